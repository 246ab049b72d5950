#include <cmath>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/surface.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {
namespace {

/// Root mean square of front(t + shift) - data(t), both in columns.
double distance(const Series& run, const Series& data, double shift) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < data.size(); ++i) errors.push_back(run.at(data.t[i] + shift) - data.y[i]);
  return rms(errors);
}

/// The shift of time that brings the run nearest to the data.
double best_shift(const Series& run, const Series& data) {
  double best = 0;
  for (int i = -200; i <= 200; ++i)
    if (distance(run, data, 0.005 * i) < distance(run, data, best)) best = 0.005 * i;
  return best;
}

}  // namespace

Findings dam_break(Bench& bench) {
  Series run;  // in the data's units: columns over t sqrt(2 g/a)
  const Parameters p = bench.scene("dam-break", {}).parameters;
  const double column = p.fluid.column, unit = std::sqrt(column / (2 * p.gravity.size()));
  const auto look = [&](const Frame& frame, const RunInfo& info) {
    run.t.push_back(frame.time / unit);
    run.y.push_back(front(frame, info.spacing) / column);
  };
  std::vector<std::string> settings{"time.end=0.3", "output.frame_rate=500"};
  if (bench.quick()) settings.emplace_back("particles.spacing=0.005715");
  bench.run("dam-break", settings, look);

  Series data = bench.reference("dambreak_martin_moyce1952_a2.25in_front", "t_sqrt_2g_over_a", "z_over_a");
  while (data.y.back() > 0.9 * tank_surface(p).size()[0] / column)
    data.t.pop_back(), data.y.pop_back();  // the run has a wall
  const double shift = best_shift(run, data);
  return {{{bench.quick() ? "front, a/10, RMS distance from the experiment" : "front, RMS distance from the experiment",
            distance(run, data, 0), "a", bench.quick() ? std::optional<Target>() : at_most(0.15)},
           {"the same, with the time shift below", distance(run, data, shift), "a", {}},
           {"shift: the run is early by, of sqrt(a/2g)", -shift, "", {}}},
          {{"Dam break: the front",
            "t sqrt(2g/a) [-]",
            "front from the left wall [a]",
            {{"run", run.t, run.y}, {"Martin and Moyce 1952", data.t, data.y, render::Mark::points}}}}};
}

}  // namespace seiche::apps::validate
