#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/fit.hpp"
#include "apps/validate/hydrostatics.hpp"
#include "solver/make_simulation.hpp"

// Tanks that aren't boxes, and boxes with baffles, 20 particles deep: at rest, and pushed once so that their liquid
// swings by itself. References are finite elements, of the program's own and of another (scenes/tanks).
namespace seiche::apps::validate {
namespace {

/// A tank, and what it is asked for.
struct Asked {
  std::string title;
  std::string scene;
  std::vector<std::string> settings;
  double error, speed;                ///< at rest, at most [%, mm/s]
  std::optional<double> period = {};  ///< within [%]; none: it isn't timed
  bool in_quick = false;
};

const std::vector<Asked>& all_tanks() {
  static const std::vector<Asked> all{
      {"circle, quarter full", "tanks/circle", {"fluid.fill_height=0.25", "particles.spacing=0.00625"}, 0.15, 12, 0.3},
      {"circle, half full", "tanks/circle", {}, 0.15, 12, 0.3, true},
      {"circle, three quarters full",
       "tanks/circle",
       {"fluid.fill_height=0.75", "particles.spacing=0.01875"},
       0.15,
       18,
       0.8},
      {"chamfer", "tanks/chamfer", {}, 0.15, 12, 0.3},
      {"hexagon", "tanks/hexagon", {}, 0.15, 12, 0.3},
      {"box turned by 20 degrees", "tanks/turned", {}, 0.15, 18},
      {"box turned by 45 degrees",
       "tanks/turned",
       {"tank.points=[[0, 0], [0.353553, 0.353553], [0.141421, 0.565685], [-0.212132, 0.212132]]"},
       0.15,
       18},
      {"baffle", "tanks/baffle", {}, 0.1, 12, 1.5},
      {"plate", "tanks/plate", {}, 0.1, 25, 2.0, true},
  };
  return all;
}

void rest(Bench& bench, const Asked& tank, std::vector<Figure>& figures) {
  const double end = bench.quick() ? 2 : 5;
  double squares = 0, fastest = 0;
  long frames = 0;
  std::vector<std::string> settings = tank.settings;
  settings.push_back(fmt::format("time.end={}", end));
  const Recording run = bench.run(tank.scene, settings, [&](const Frame& frame, const RunInfo& info) {
    if (frame.time < 1) return;
    squares += std::pow(hydrostatic_error(frame, info), 2);
    fastest = std::max(fastest, greatest_speed(frame));
    ++frames;
  });
  const Series& volume = run.sensors.at("volume");
  const double start = volume.y.front(), last = volume.between(end - 0.5, end).y.back();
  figures.push_back({tank.title + ": RMS pressure error over rho g H, from 1 s",
                     100 * std::sqrt(squares / static_cast<double>(frames)), "%", at_most(tank.error)});
  figures.push_back({tank.title + ": greatest speed, from 1 s", 1000 * fastest, "mm/s", at_most(tank.speed)});
  figures.push_back({tank.title + ": volume below the surface, change", 100 * (last / start - 1), "%", within(0.1)});
  figures.push_back({tank.title + ": leaked", static_cast<double>(run.statistics.leaked), "", within(0)});
}

/// After a push of 4 mm within 0.4 s the tank stands, and the liquid's centre of mass swings with the first wave.
void swing(Bench& bench, const Asked& tank, Findings& found, Chart& chart) {
  std::vector<std::string> settings = tank.settings;
  settings.insert(settings.end(), {"motion.type=file", "motion.file=kick.csv", "motion.start=smooth", "time.end=11",
                                   "output.frame_rate=5"});
  const double period = natural_modes(bench.scene(tank.scene, settings).parameters, 1).at(0).period;
  const Recording run = bench.run(tank.scene, settings);
  Series centre = run.sensors.at("x_mass").between(1, 11);
  double mean = 0;
  for (const double x : centre.y) mean += x / static_cast<double>(centre.size());
  for (double& x : centre.y) x -= mean;
  const double omega = 2 * std::numbers::pi / period;
  found.figures.push_back({tank.title + ": period less that of finite elements",
                           100 * (omega / fit_oscillation(centre, omega).omega - 1), "%", within(*tank.period)});
  const auto [least, most] = std::minmax_element(centre.y.begin(), centre.y.end());
  Series share = centre;
  for (double& x : share.y) x /= *most - *least;
  chart.curves.push_back({tank.title, share.t, share.y});
}

}  // namespace

Findings tanks(Bench& bench) {
  Findings found;
  Chart chart{"Free sloshing, 20 particles deep", "t [s]", "centre of mass over its whole way [-]", {}};
  for (const Asked& tank : all_tanks()) {
    if (bench.quick() && !tank.in_quick) continue;
    rest(bench, tank, found.figures);
    if (tank.period && !bench.quick()) swing(bench, tank, found, chart);
  }
  if (!chart.curves.empty()) found.charts = {chart};
  return found;
}

}  // namespace seiche::apps::validate
