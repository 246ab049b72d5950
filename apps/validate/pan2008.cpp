#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "apps/validate/case.hpp"
#include "apps/validate/filter.hpp"
#include "apps/validate/fit.hpp"
#include "apps/validate/measures.hpp"
#include "apps/validate/surface.hpp"

// The tank of Pan, Zhang and Lu (2008) against fully nonlinear potential theory. Where theory and two-fluid codes
// differ among themselves by 2.6 and 4 % in elevation and by 1.2 and 3.4 % in pressure (0.5-4 s, 4-7 s), nothing better
// than that can be asked of a run.
namespace seiche::validate {
namespace {

constexpr double cut = 10;  // noise is what lies above it [Hz]
constexpr const char* corner = "p_left_bottom [Pa]";
constexpr const char* theory = "theory_fnpf_impulsive";

/// One spacing's run, and what is asked of it; nothing where the run is too short for it.
struct Resolution {
  double spacing, end;  // [m], [s]
  std::optional<Target> early_noise = {}, late_noise = {}, mean_pressure = {}, early_pressure = {}, late_pressure = {};
  std::optional<Target> early_level = {}, first_level = {}, later_level = {};
};

const std::vector<Resolution> resolutions{
    {.spacing = 0.01, .end = 7, .early_noise = at_most(0.2), .early_level = at_most(0.06)},
    {.spacing = 0.005,
     .end = 10,
     .early_noise = at_most(0.1),
     .late_noise = at_most(0.4),
     .mean_pressure = within(0.5),
     .early_pressure = at_most(2),
     .late_pressure = at_most(6),
     .early_level = at_most(0.04),
     .first_level = at_most(3),
     .later_level = at_most(5)},
    {.spacing = 0.0025, .end = 3.05, .early_level = at_most(0.025)},
};

struct References {
  Series left, right, pressure;
  std::map<double, Series> profiles;  // by time [s]; z over x [m]
};

References read_references(const Bench& bench) {
  References r{bench.reference(theory, "t", "eta_left"),
               bench.reference(theory, "t", "eta_right"),
               bench.reference(theory, "t", "p_left_bottom"),
               {}};
  const std::string profiles = std::string(theory) + "_profiles";
  const Series x = bench.reference(profiles, "t", "x"), z = bench.reference(profiles, "t", "z");
  for (std::size_t i = 0; i < x.size(); ++i) {
    r.profiles[x.t[i]].t.push_back(x.y[i]);
    r.profiles[x.t[i]].y.push_back(z.y[i]);
  }
  return r;
}

/// A run's sensors, and its surface over x at each frame.
struct Run {
  Recording recording;
  std::map<double, Series> profiles;
  Series mean_height;

  const Series& sensor(const char* column) const { return recording.sensors.at(column); }
};

Run make_run(Bench& bench, const Resolution& of) {
  Run run;
  const auto look = [&](const Frame& frame, const RunInfo& info) {
    const std::vector<double> x = stations(info.tank[0], 60), z = surface_heights(frame, info, x);
    run.profiles[frame.time] = {x, z};
    run.mean_height.t.push_back(frame.time);
    run.mean_height.y.push_back(std::accumulate(z.begin(), z.end(), 0.0) / z.size());
  };
  run.recording = bench.run(
      "pan2008",
      {fmt::format("particles.spacing={}", of.spacing), fmt::format("time.end={}", of.end), "output.frame_rate=20"},
      look);
  return run;
}

/// RMS distance of the profiles at 1, 2 and 3 s from theory's, 10 mm off the walls and further [m].
double profile_error(const Run& run, const References& theory) {
  ProfileDistance sum;
  for (const double t : {1.0, 2.0, 3.0}) {
    const ProfileDistance d = profile_distance(theory.profiles.at(t), run.profiles.at(t), 0.01, 0.59);
    sum.squares += d.squares;
    sum.count += d.count;
  }
  return std::sqrt(sum.squares / sum.count);
}

double mean_height(const Run& run, double from, double to) {
  const Series part = run.mean_height.between(from, to);
  return std::accumulate(part.y.begin(), part.y.end(), 0.0) / part.size();
}

/// The worse of the two walls.
template <class Measure>
double worse_wall(const Run& run, const References& theory, double from, double to, Measure measure) {
  const Window window{from, to};
  return std::max(measure(compare(theory.left, run.sensor("eta_left [m]"), window)),
                  measure(compare(theory.right, run.sensor("eta_right [m]"), window)));
}

void add_pressure_figures(std::vector<Figure>& figures, const std::string& title, const Resolution& of, const Run& run,
                          const References& theory) {
  const Parameters& p = run.recording.parameters;
  const double weight = p.fluid.density * p.gravity * p.fluid.depth;
  const Series& pressure = run.sensor(corner);
  const auto below_cut = [&](double from, double to) {
    const Window window{from, to, weight};
    return 100 * compare(theory.pressure, low_pass(pressure, from, to, cut), window).unbiased_of_most();
  };
  const auto add = [&](const char* name, double value, const std::optional<Target>& target) {
    figures.push_back({title + name, value, "%", target});
  };
  add("corner pressure above 10 Hz, RMS over rho g h, 0.5-3 s", 100 * noise(pressure, 0.5, 3, cut) / weight,
      of.early_noise);
  if (of.end < 7) return;
  add("the same, 3-7 s", 100 * noise(pressure, 3, 7, cut) / weight, of.late_noise);
  add("corner pressure, mean error over rho g h, 0.5-7 s",
      100 * compare(theory.pressure, pressure, {0.5, 7, weight}).bias / weight, of.mean_pressure);
  add("corner pressure below 10 Hz less its mean error, RMS over max, 0.5-4 s", below_cut(0.5, 4), of.early_pressure);
  add("the same, 4-7 s", below_cut(4, 7), of.late_pressure);
}

void add_level_figures(std::vector<Figure>& figures, const std::string& title, const Resolution& of, const Run& run,
                       const References& theory) {
  const auto of_most = [](const Difference& d) { return 100 * d.of_most(); };
  figures.push_back({title + "worse wall's elevation, relative L2, 0-3 s",
                     worse_wall(run, theory, 0, 3, [](const Difference& d) { return d.relative_l2(); }), "",
                     of.early_level});
  if (of.end < 7) return;
  figures.push_back({title + "worse wall's elevation, RMS over max, 0.5-4 s", worse_wall(run, theory, 0.5, 4, of_most),
                     "%", of.first_level});
  figures.push_back({title + "the same, 4-7 s", worse_wall(run, theory, 4, 7, of_most), "%", of.later_level});
  if (of.end < 10) return;
  const double depth = run.recording.parameters.fluid.depth;
  figures.push_back({title + "mean surface height, 6-7 s less 0-1 s, of the depth",
                     100 * (mean_height(run, 6, 7) - mean_height(run, 0, 1)) / depth, "%", within(0.3)});
  figures.push_back(
      {title + "particles lost in 10 s", static_cast<double>(run.recording.statistics.leaked), "", at_most(0)});
}

Series scaled(Series series, double rest, double factor) {
  for (double& y : series.y) y = factor * (y - rest);
  return series;
}

render::Curve curve(const std::string& name, const Series& s, render::Mark mark = render::Mark::line) {
  return {name, s.t, s.y, mark};
}

std::string millimetres(double spacing) { return fmt::format("{:g} mm", 1000 * spacing); }

std::vector<Chart> charts(const std::vector<Run>& runs, const References& theory) {
  const Parameters& p = runs[0].recording.parameters;
  const double weight = p.fluid.density * p.gravity * p.fluid.depth;
  Chart level{"Surge near resonance: left wall", "t [s]", "elevation [mm]", {}};
  Chart pressure{"Surge near resonance: left bottom corner", "t [s]", "pressure less 1962 Pa [Pa]", {}};
  Chart profile{"Surge near resonance: surface at 3 s", "x [mm]", "elevation [mm]", {}};
  const auto over_x = [&](const Series& z) {
    Series result = scaled(z, p.fluid.depth, 1000);
    for (double& x : result.t) x *= 1000;
    return result;
  };
  for (const Run& run : runs) {
    const std::string name = millimetres(run.recording.parameters.particles.spacing);
    level.curves.push_back(curve(name, scaled(run.sensor("eta_left [m]").between(0, 7), 0, 1000)));
    pressure.curves.push_back(curve(name, scaled(run.sensor(corner).between(0, 7), weight, 1)));
    profile.curves.push_back(curve(name, over_x(run.profiles.at(3))));
  }
  const auto dashes = render::Mark::dashes;
  level.curves.push_back(curve("potential theory", scaled(theory.left.between(0, 7), 0, 1000), dashes));
  pressure.curves.push_back(curve("potential theory", scaled(theory.pressure.between(0, 7), weight, 1), dashes));
  profile.curves.push_back(curve("potential theory", over_x(theory.profiles.at(3)), dashes));
  return {level, pressure, profile};
}

}  // namespace

Findings pan2008(Bench& bench) {
  const References theory = read_references(bench);
  Findings findings;
  std::vector<Run> runs;
  std::vector<double> spacings, errors;
  for (const Resolution& of : resolutions) {
    if (bench.quick() && !runs.empty()) break;
    runs.push_back(make_run(bench, of));
    const std::string title = millimetres(of.spacing) + ": ";
    add_pressure_figures(findings.figures, title, of, runs.back(), theory);
    add_level_figures(findings.figures, title, of, runs.back(), theory);
    spacings.push_back(of.spacing);
    errors.push_back(profile_error(runs.back(), theory));
    findings.figures.push_back({title + "profiles at 1, 2, 3 s, RMS distance", 1000 * errors.back(), "mm", {}});
  }
  if (runs.size() == resolutions.size())
    findings.figures.push_back({"order of the profiles' distance in l0", order(spacings, errors), "", at_least(1)});
  findings.charts = charts(runs, theory);
  return findings;
}

}  // namespace seiche::validate
