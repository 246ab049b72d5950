#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/fit.hpp"
#include "solver/make_simulation.hpp"

// Motions in several degrees of freedom at once, in 3-D.
namespace seiche::apps::validate {
namespace {

constexpr const char* cylinder = "tanks/upright";  ///< as deep as its radius, 12 spacings

/// Amplitude of the part of a series that goes with omega, over whole periods.
double component(const Series& series, double omega) {
  double in_phase = 0, across = 0;
  for (std::size_t i = 0; i < series.size(); ++i) {
    in_phase += series.y[i] * std::sin(omega * series.t[i]);
    across += series.y[i] * std::cos(omega * series.t[i]);
  }
  return 2 * std::hypot(in_phase, across) / static_cast<double>(series.size());
}

/// The wave at the wall of a cylinder on a circular orbit of radius A, linear (Lamb 1932, art. 191, forced):
///   eta/A = W (1 + sum_n 2/(xi_n^2 - 1) W/(xi_n tanh(xi_n h/R) - W)), W = omega^2 R/g, h = R,
/// xi_n the zeros of J_1' (Abramowitz & Stegun, table 9.5).
double orbit_theory(double w) {
  constexpr double zeros[] = {1.84118, 5.33144, 8.53632, 11.70600, 14.86359, 18.01553, 21.16437, 24.31133};
  double sum = 1;
  for (const double xi : zeros) sum += 2 / (xi * xi - 1) * w / (xi * std::tanh(xi) - w);
  return w * sum;
}

void orbit(Bench& bench, Findings& found) {
  const Parameters p = bench.scene(cylinder, {}).parameters;
  const double radius = p.tank.radius, g = p.gravity.size(), amplitude = radius / 100, share = 0.8;
  const double xi = 1.84118, first = std::sqrt(g * xi / radius * std::tanh(xi)), omega = share * first;
  const double period = 2 * std::numbers::pi / omega;
  const auto term = [&](const char* of, double phase) {
    return fmt::format("{{of = \"{}\", amplitude = {}, frequency = {}, phase = {}}}", of, amplitude, 1 / period, phase);
  };
  const Recording run =
      bench.run(cylinder,
                {"motion.type=harmonics", fmt::format("motion.harmonic=[{}, {}]", term("surge", 90), term("sway", 180)),
                 fmt::format("motion.ramp={}", 8 * period), "motion.start=smooth",
                 fmt::format("time.end={}", 16 * period), "output.frame_rate=5"},
                {}, {0.999 * radius});
  const Series all = run.sensors.at(station_column(0));
  const double wave = component(all.between(8 * period, 16 * period), omega) / amplitude;
  const double theory = orbit_theory(omega * omega * radius / g);
  found.figures.push_back({"cylinder on an orbit of R/100 at 0.8 omega_1: wave at the wall over A", wave, "", {}});
  found.figures.push_back({"the same, less that of linear theory, of it", 100 * (wave / theory - 1), "%", within(4)});
  const Series swirl = run.sensors.at("swirl").between(8 * period, 16 * period);
  const double least = *std::min_element(swirl.y.begin(), swirl.y.end());
  const double mean = std::accumulate(swirl.y.begin(), swirl.y.end(), 0.0) / static_cast<double>(swirl.size());
  found.figures.push_back({"the same: least swirl over its mean, the orbit anticlockwise", least / mean, "", {}});
}

/// Steadily yawing liquid keeps the paraboloid that it starts under, omega^2 r^2/(2 g); without friction at the wall
/// what starts at rest in the lab stays flat.
void yaw(Bench& bench, Findings& found, const char* start) {
  const Parameters p = bench.scene(cylinder, {}).parameters;
  const bool level = std::string(start) == "level";
  const double radius = p.tank.radius, l0 = p.particles.spacing, height = level ? 4 * l0 : 0;
  const std::vector<double> places{0, 0.4 * radius, 0.8 * radius};
  const Recording run = bench.run(cylinder,
                                  {"motion.type=file", "motion.file=yaw.csv", fmt::format("motion.start={}", start),
                                   "time.end=5", "output.frame_rate=5"},
                                  {}, places);
  double worst = 0;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double share = places[k] / radius, expected = height * (share * share - 0.5);
    for (const double eta : run.sensors.at(station_column(k)).between(1, 5).y)
      worst = std::max(worst, std::abs(eta - expected));
  }
  const char* name = level ? "cylinder yawing steadily, level start: surface from its paraboloid, 1-5 s, greatest"
                           : "cylinder that begins to yaw: surface from flat, 1-5 s, greatest";
  found.figures.push_back({name, worst / l0, "l0", at_most(0.3)});
}

/// Pushed at 45 degrees to its sides a square box has the same wave along both.
void diagonal(Bench& bench, Findings& found) {
  const std::vector<std::string> settings{"motion.type=file", "motion.file=kick-diagonal.csv", "motion.start=smooth",
                                          "time.end=8", "output.frame_rate=5"};
  const double period = natural_modes(bench.scene("tanks/square", settings).parameters, 1).at(0).period;
  const Recording run = bench.run("tanks/square", settings);
  const double omega = 2 * std::numbers::pi / period;
  std::vector<Series> centres;
  for (const char* column : {"x_mass", "z_mass"}) {
    Series centre = run.sensors.at(column).between(1, 8);
    const double mean = std::accumulate(centre.y.begin(), centre.y.end(), 0.0) / static_cast<double>(centre.size());
    for (double& x : centre.y) x -= mean;
    found.figures.push_back(
        {fmt::format("square box swayed at 45 degrees, {}: period less that of linear theory", column),
         100 * (omega / fit_oscillation(centre, omega).omega - 1), "%", within(0.5)});
    centres.push_back(std::move(centre));
  }
  double apart = 0, squares = 0;
  for (std::size_t i = 0; i < centres[0].size(); ++i) {
    apart += std::pow(centres[0].y[i] - centres[1].y[i], 2);
    squares += std::pow(centres[0].y[i], 2);
  }
  found.figures.push_back(
      {"the same: RMS of x_mass less z_mass over that of x_mass", 100 * std::sqrt(apart / squares), "%", at_most(2)});
}

}  // namespace

Findings motions(Bench& bench) {
  Findings found;
  if (bench.quick()) return found;
  diagonal(bench, found);
  yaw(bench, found, "level");
  yaw(bench, found, "impulsive");
  orbit(bench, found);
  return found;
}

}  // namespace seiche::apps::validate
