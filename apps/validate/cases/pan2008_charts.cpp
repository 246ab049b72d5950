#include "apps/validate/cases/pan2008_runs.hpp"
#include "apps/validate/surface.hpp"

namespace seiche::apps::validate::pan {
namespace {

Series scaled(Series series, double rest, double factor) {
  for (double& y : series.y) y = factor * (y - rest);
  return series;
}

render::Curve curve(const std::string& name, const Series& s, render::Mark mark = render::Mark::line) {
  return {name, s.t, s.y, mark};
}

}  // namespace

std::vector<Chart> charts(const std::vector<Run>& runs, const References& theory) {
  const double depth = runs[0].recording.parameters.fluid.depth, weight = runs[0].weight();
  Chart level{"Surge near resonance: left wall", "t [s]", "elevation [mm]", {}};
  Chart pressure{"Surge near resonance: left bottom corner", "t [s]", "pressure less 1962 Pa [Pa]", {}};
  Chart profile{"Surge near resonance: surface at 3 s", "x [mm]", "elevation [mm]", {}};
  const auto over_x = [&](const Series& z) {
    Series result = scaled(z, depth, 1000);
    for (double& x : result.t) x *= 1000;
    return result;
  };
  for (const Run& run : runs) {
    const std::string name = millimetres(run.spacing());
    level.curves.push_back(curve(name, scaled(run.left().between(0, 7), 0, 1000)));
    pressure.curves.push_back(curve(name, scaled(run.pressure().between(0, 7), weight, 1)));
    profile.curves.push_back(curve(name, over_x(validate::profile(run.recording, 3))));
  }
  const auto dashes = render::Mark::dashes;
  level.curves.push_back(curve("potential theory", scaled(theory.left.between(0, 7), 0, 1000), dashes));
  pressure.curves.push_back(curve("potential theory", scaled(theory.pressure.between(0, 7), weight, 1), dashes));
  profile.curves.push_back(curve("potential theory", over_x(theory.profiles.at(3)), dashes));
  return {level, pressure, profile};
}

}  // namespace seiche::apps::validate::pan
