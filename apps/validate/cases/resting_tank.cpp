#include "apps/validate/cases/resting_tank.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/validate/fit.hpp"
#include "apps/validate/hydrostatics.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {

void rest(Bench& bench, const Asked& tank, std::vector<Figure>& figures) {
  const double froude = std::sqrt(tank.scale), end = bench.quick() ? 2 : tank.still_end;
  double squares = 0, moving = 0, fastest = 0;
  long frames = 0;
  std::vector<std::string> settings = tank.settings;
  settings.push_back(fmt::format("time.end={}", end * froude));
  if (tank.scale != 1) settings.push_back(fmt::format("output.frame_rate={}", 20 / froude));
  const StillPressure still(bench.scene(tank.scene, settings).parameters);
  const Recording run = bench.run(tank.scene, settings, [&](const Frame& frame, const RunInfo&) {
    if (frame.time < froude) return;
    squares += std::pow(still.error(frame), 2);
    moving += std::pow(rms_speed(frame) / froude, 2);
    fastest = std::max(fastest, greatest_speed(frame) / froude);
    ++frames;
  });
  const auto add = [&](const char* name, double value, const char* unit, const std::optional<Target>& target) {
    figures.push_back({tank.title + ": " + name, value, unit, target});
  };
  const auto count = static_cast<double>(frames);
  add("RMS pressure error over rho g H, from 1 s", 100 * std::sqrt(squares / count), "%", at_most(tank.error));
  if (tank.rms_speed) add("RMS speed, from 1 s", 1000 * std::sqrt(moving / count), "mm/s", at_most(*tank.rms_speed));
  add("greatest speed, from 1 s", 1000 * fastest, "mm/s", at_most(tank.speed));
  if (tank.level) {
    const Series& volume = run.sensors.at("volume");
    const double last = volume.between((end - 0.5) * froude, end * froude).y.back();
    add("volume below the surface, change", 100 * (last / volume.y.front() - 1), "%", within(*tank.level));
  }
  add("leaked", static_cast<double>(run.statistics.leaked), "", at_most(0));
}

void swing(Bench& bench, const Asked& tank, Findings& found, Chart& chart) {
  std::vector<std::string> settings = tank.settings;
  settings.insert(settings.end(), {"motion.type=file", "motion.file=kick.csv", "motion.start=smooth",
                                   fmt::format("time.end={}", tank.swing_end), "output.frame_rate=5"});
  const double period = natural_modes(bench.scene(tank.scene, settings).parameters, 1).at(0).period;
  const Recording run = bench.run(tank.scene, settings);
  Series centre = run.sensors.at("x_mass").between(1, tank.swing_end);
  double mean = 0;
  for (const double x : centre.y) mean += x / static_cast<double>(centre.size());
  for (double& x : centre.y) x -= mean;
  const double omega = 2 * std::numbers::pi / period;
  found.figures.push_back({tank.title + ": period less that of linear theory",
                           100 * (omega / fit_oscillation(centre, omega).omega - 1), "%", within(*tank.period)});
  const auto [least, most] = std::minmax_element(centre.y.begin(), centre.y.end());
  Series share = centre;
  for (double& x : share.y) x /= *most - *least;
  chart.curves.push_back({tank.title, share.t, share.y});
}

Findings rest_and_swing(Bench& bench, const std::vector<Asked>& tanks, const std::string& chart_title) {
  Findings found;
  Chart chart{chart_title, "t [s]", "centre of mass over its whole way [-]", {}};
  for (const Asked& tank : tanks) {
    if (bench.quick() && !tank.in_quick) continue;
    rest(bench, tank, found.figures);
    if (tank.period && !bench.quick()) swing(bench, tank, found, chart);
  }
  if (!chart.curves.empty()) found.charts = {chart};
  return found;
}

}  // namespace seiche::apps::validate
