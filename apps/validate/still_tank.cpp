#include <algorithm>
#include <cmath>

#include "apps/validate/case.hpp"
#include "apps/validate/surface.hpp"

namespace seiche::validate {
namespace {

/// Root mean square over the fluid of p - rho g (depth - y), over rho g depth [-].
double hydrostatic_error(const Frame& frame, const RunInfo& run) {
  const double weight = run.density * run.gravity;
  std::vector<double> errors;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) errors.push_back(frame.pressure[i] - weight * (run.depth - frame.position[i][1]));
  return rms(errors) / (weight * run.depth);
}

double fastest(const Frame& frame) {
  double most = 0;
  for (const Float3& v : frame.velocity) most = std::max<double>(most, std::hypot(v[0], v[1]));
  return most;
}

double greatest(const Series& series) { return *std::max_element(series.y.begin(), series.y.end()); }

}  // namespace

Findings still_tank(Bench& bench) {
  Series error, speed;
  const auto look = [&](const Frame& frame, const RunInfo& run) {
    for (Series* series : {&error, &speed}) series->t.push_back(frame.time);
    error.y.push_back(100 * hydrostatic_error(frame, run));
    speed.y.push_back(1000 * fastest(frame));
  };
  const double length = bench.scene("still-tank", {}).parameters.tank.length;
  const Recording run = bench.run("still-tank", {"time.end=10", "output.frame_rate=25"}, look, stations(length, 50));

  const double change = 100 * (mean_height(run, 9.4, 10) - mean_height(run, 0, 0)) / run.parameters.fluid.depth;
  return {{{"RMS pressure error over rho g H, 0.4-1 s", rms(error.between(0.4, 1).y), "%", at_most(1)},
           {"the same, 9.4-10 s", rms(error.between(9.4, 10).y), "%", at_most(1)},
           {"mean surface height, 9.4-10 s less 0 s, of the depth", change, "%", within(0.1)},
           {"greatest speed, 0.4-10 s", greatest(speed.between(0.4, 10)), "mm/s", at_most(10)},
           {"greatest speed, 9-10 s", greatest(speed.between(9, 10)), "mm/s", at_most(10)}},
          {{"Still tank, 10 mm: what moves",
            "t [s]",
            "greatest speed [mm/s]",
            {{"run", speed.t, speed.y}, {"target", {0, 10}, {10, 10}, render::Mark::dashes}}}}};
}

}  // namespace seiche::validate
