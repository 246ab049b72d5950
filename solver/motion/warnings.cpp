#include "solver/motion/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "solver/motion/motion.hpp"
#include "solver/motion/record.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {
namespace {

using Warning = std::optional<std::string>;

using solver::standard_gravity;

/// The largest tanks that carry liquid at sea are 60 m long, storage tanks on land 100 m wide.
Warning of_size(const Parameters& p) {
  const Double3 size = solver::wall_surface(p).size();
  const double longest = *std::max_element(size.begin(), size.end());
  if (longest <= 150) return {};
  return fmt::format("the tank is {:g} m long; lengths are in metres", longest);
}

Warning of_acceleration(const Parameters& p) {
  const auto [greatest, when] = greatest_acceleration(p);
  if (greatest <= 2 * standard_gravity) return {};
  return fmt::format("the tank's acceleration reaches {:.3g} m/s^2, {:.3g} g, at {:.3g} s; lengths are in metres",
                     greatest, greatest / standard_gravity, when);
}

double rms_acceleration(const Parameters::Motion& m, const std::vector<double>& record) {
  const std::vector<double>& t = m.series.time;
  const solver::Spline spline(t, m.cutoff > 0 ? solver::smoothed(t, record, m.cutoff) : record);
  double sum = 0;
  for (const double time : t) sum += std::pow(spline.at(time).acceleration, 2);
  return std::sqrt(sum / static_cast<double>(t.size()));
}

/// Half of an acceleration, by its RMS, may be made by rounding before it is said to be mostly that.
Warning of_rounding(const Parameters::Motion& m, const DegreeOfFreedomRow& row) {
  if (m.type != MotionType::file || m.series[row.value].empty()) return {};
  const double rms = rms_acceleration(m, m.series[row.value]);
  const double rounding = solver::rounding_acceleration(m.series.time, m.series[row.value], m.cutoff);
  // Far more than there is in all: its steps aren't those of rounding, as in a record that was thinned.
  if (rms == 0 || rounding <= 0.5 * rms || rounding > 2 * rms) return {};
  return fmt::format(
      "{}: the accelerations of {} are mostly rounding: {:.3g} of {:.3g} {}/s^2 RMS come from the steps of its values "
      "and "
      "times; smooth it with motion.cutoff, some 3 to 5 times its highest frequency in Hz",
      m.file, row.name, rounding, rms, row.unit());
}

Warning of_start(const Parameters& p, const solver::Motion& motion) {
  const Eigen::Vector3d g(p.gravity[0], p.gravity[1], p.gravity[2]);
  if (g.norm() == 0 || p.motion.start == Start::level) return {};
  const Eigen::Vector3d in_tank = motion.state(0).orientation.conjugate() * g;
  const double tilt = std::atan2(g.cross(in_tank).norm(), g.dot(in_tank)) * 180 / std::numbers::pi;
  if (tilt < 0.1) return {};
  return fmt::format(
      "the tank starts tilted by {:.3g} degrees, and the liquid with its surface as in an upright tank: take "
      "motion.start = level, or begin with a motion.ramp",
      tilt);
}

/// The speed that a tank loses or gains at once where a record is held.
Warning of_holding(const Parameters& p, const solver::Motion& motion) {
  const Parameters::Motion& m = p.motion;
  if (m.type != MotionType::file || !m.hold) return {};
  for (const double end : {m.series.time.front() - m.from, m.series.time.back() - m.from}) {
    if (end <= 0 || end >= p.time.end) continue;
    const double before = motion.state(end).velocity.norm();
    if (before > 1e-3 * motion.fastest())
      return fmt::format("the tank's speed jumps by {:.3g} m/s at {:.3g} s, where the motion's file is held", before,
                         end);
  }
  return {};
}

}  // namespace

PeakAcceleration greatest_acceleration(const Parameters& p) {
  const solver::Motion motion(p.motion);
  const SurfaceMesh wall = solver::wall_surface(p);
  const Double3 low = wall.low(), high = wall.high();
  PeakAcceleration peak;
  const auto looks = std::max<std::size_t>(10 * p.motion.series.time.size(), 1000);
  for (std::size_t k = 0; k <= looks; ++k) {
    const double t = p.time.end * static_cast<double>(k) / static_cast<double>(looks);
    const RigidState tank = motion.state(t);
    for (int corner = 0; corner < 8; ++corner) {
      Eigen::Vector3d arm = -tank.pivot;
      for (int axis = 0; axis < 3; ++axis)
        arm[axis] +=
            (corner >> axis & 1) != 0 ? high[static_cast<std::size_t>(axis)] : low[static_cast<std::size_t>(axis)];
      const double here = (tank.orientation.conjugate() * tank.acceleration + tank.alpha.cross(arm) +
                           tank.omega.cross(tank.omega.cross(arm)))
                              .norm();
      if (here > peak.value) peak = {here, t};
      if (!motion.rotates()) break;
    }
  }
  return peak;
}

std::vector<std::string> warnings(const Parameters& p) {
  const solver::Motion motion(p.motion);
  std::vector<std::string> all;
  const auto add = [&](const Warning& warning) {
    if (warning) all.push_back(*warning);
  };
  add(of_size(p));
  add(of_acceleration(p));
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) add(of_rounding(p.motion, row));
  add(of_start(p, motion));
  add(of_holding(p, motion));
  return all;
}

}  // namespace seiche
