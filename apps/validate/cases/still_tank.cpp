#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/hydrostatics.hpp"
#include "apps/validate/surface.hpp"
#include "apps/validate/surface_flags.hpp"
#include "solver/make_simulation.hpp"

// Two tanks at rest, of 0.5 and 20 m. By Froude's law times and speeds grow with the root of the depth, so the large
// one is run, looked at and judged at the small one's times and speeds.
namespace seiche::apps::validate {
namespace {

constexpr double model_depth = 0.2;                // whose times and speeds figures are given in [m]
constexpr double end = 10, frame_interval = 0.04;  // at that depth [s]

/// A tank's run.
struct StillTank {
  std::string title;    ///< as in "0.5 m"
  double froude;        ///< its times and speeds over those at the model's depth
  Recording recording;  ///< at its own times
  Series error, speed;  ///< RMS pressure error [%], and greatest speed [mm/s], at the model's times and speeds
  SurfaceFlags flags;   ///< at its own times
};

double greatest(const Series& series) { return *std::max_element(series.y.begin(), series.y.end()); }

StillTank make_run(Bench& bench, const std::string& scene) {
  const Parameters p = bench.scene(scene, {}).parameters;
  StillTank tank{.title = fmt::format("{:g} m{}", tank_surface(p).size()[0],
                                      p.fluid.depth == model_depth ? "" : ", by Froude's law"),
                 .froude = std::sqrt(p.fluid.depth / model_depth),
                 .recording = {},
                 .error = {},
                 .speed = {},
                 .flags = {}};
  const StillPressure still(p);
  const auto look = [&tank, &still](const Frame& frame, const RunInfo&) {
    for (Series* series : {&tank.error, &tank.speed}) series->t.push_back(frame.time / tank.froude);
    tank.error.y.push_back(100 * still.error(frame));
    tank.speed.y.push_back(1000 * greatest_speed(frame) / tank.froude);
    tank.flags.see(frame);
  };
  tank.recording = bench.run(scene,
                             {fmt::format("time.end={}", end * tank.froude),
                              fmt::format("output.frame_rate={}", 1 / (frame_interval * tank.froude)),
                              fmt::format("output.probe_rate={}", 1000 / tank.froude)},
                             look, stations(tank_surface(p).size()[0], 50));
  return tank;
}

void add_figures(std::vector<Figure>& figures, const StillTank& tank) {
  const auto height = [&](double from, double to) {
    return mean_height(tank.recording, from * tank.froude, to * tank.froude);
  };
  const double change = 100 * (height(9.4, end) - height(0, 0)) / tank.recording.parameters.fluid.depth;
  const auto changing = [&](double from) { return 100 * tank.flags.changing(from * tank.froude, end * tank.froude); };
  const auto add = [&](const std::string& name, double value, const char* unit, const std::optional<Target>& target) {
    figures.push_back({tank.title + ": " + name, value, unit, target});
  };
  add("RMS pressure error over rho g H, 0.4-1 s", rms(tank.error.between(0.4, 1).y), "%", at_most(1));
  add("the same, 9.4-10 s", rms(tank.error.between(9.4, end).y), "%", at_most(1));
  add("mean surface height, 9.4-10 s less 0 s, of the depth", change, "%", within(0.1));
  add("greatest speed, 0.4-10 s", greatest(tank.speed.between(0.4, end)), "mm/s", at_most(10));
  add("greatest speed, 9-10 s", greatest(tank.speed.between(9, end)), "mm/s", at_most(10));
  add(fmt::format("surface flags that change in {:g} s, 0.4-10 s", frame_interval), changing(0.4), "%", {});
  add("the same, 9-10 s", changing(9), "%", {});
}

}  // namespace

Findings still_tank(Bench& bench) {
  Findings findings;
  Chart speed{"Still tanks, 20 particles deep: what moves", "t [s]", "greatest speed [mm/s]", {}};
  Chart error{"Still tanks, 20 particles deep: pressure", "t [s]", "RMS error over rho g H [%]", {}};
  for (const char* scene : {"still-tank", "still-lng"}) {
    const StillTank tank = make_run(bench, scene);
    add_figures(findings.figures, tank);
    speed.curves.push_back({tank.title, tank.speed.t, tank.speed.y});
    error.curves.push_back({tank.title, tank.error.t, tank.error.y});
  }
  speed.curves.push_back({"target", {0, end}, {10, 10}, render::Mark::dashes});
  findings.charts = {error, speed};
  return findings;
}

}  // namespace seiche::apps::validate
