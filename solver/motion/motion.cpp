#include "solver/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

constexpr double degree = std::numbers::pi / 180;

// The terms of a motion that is no file: a single one stands for itself.
std::vector<Parameters::Harmonic> harmonics(const Parameters::Motion& m) {
  if (m.type == "harmonics") return m.harmonics;
  if (m.type == "none" || m.type == "file") return {};
  return {{m.type, m.amplitude, m.frequency, m.phase}};
}

Course course(const Parameters::Motion& m, const char* of, const std::vector<double>& samples, double unit) {
  Course result(m.ramp);
  for (const Parameters::Harmonic& h : harmonics(m))
    if (h.of == of) result.add(h.amplitude * unit, h.frequency, h.phase * degree);
  if (m.type == "file" && !samples.empty()) {
    std::vector<double> values = samples;
    for (double& value : values) value *= unit;
    result.follow(Spline(m.series.time, std::move(values)));
  }
  return result;
}

}  // namespace

Motion::Motion(const Parameters::Motion& m)
    : surge_(course(m, "surge", m.series.surge, 1)),
      heave_(course(m, "heave", m.series.heave, 1)),
      roll_(course(m, "roll", m.series.roll, degree)),
      pivot_x_(m.pivot_x),
      pivot_y_(m.pivot_y),
      spin_(m.start == Start::impulsive ? 0 : roll_.at(0).rate),
      impulsive_(m.start == Start::impulsive) {}

bool Motion::jumps() const { return impulsive_ && (surge(0).rate != 0 || heave(0).rate != 0 || roll(0).rate != 0); }

double Motion::fastest(double reach) const {
  return std::hypot(surge_.fastest(), heave_.fastest()) + reach * roll_.fastest();
}

Double3 Motion::extent(const Double3& low, const Double3& high) const {
  const double angle = std::min(roll_.greatest(), std::numbers::pi);
  const double across = std::sin(std::min(angle, std::numbers::pi / 2)), along = 1 - std::cos(angle);
  const double x = std::max(std::abs(low[0] - pivot_x_), std::abs(high[0] - pivot_x_));
  const double y = std::max(std::abs(low[1] - pivot_y_), std::abs(high[1] - pivot_y_));
  return {surge_.greatest() + along * x + across * y, heave_.greatest() + along * y + across * x, 0};
}

TankPose Motion::pose(double t) const {
  const Jet x = surge(t), y = heave(t), angle = roll(t);
  return {{x.value, y.value, 0}, {x.rate, y.rate, 0}, angle.value, angle.rate, {pivot_x_, pivot_y_, 0}};
}

void Motion::append(double t, std::vector<double>& values) const {
  if (surge_.moves()) values.push_back(surge(t).value);
  if (heave_.moves()) values.push_back(heave(t).value);
  if (roll_.moves()) values.push_back(roll(t).value / degree);
}

std::vector<Column> motion_columns(const Parameters::Motion& m, const Double3& excursion) {
  std::vector<Column> columns;
  if (course(m, "surge", m.series.surge, 1).moves())
    columns.push_back({"surge", "m", "surge", ColumnKind::translation, Rest::zero, excursion[0]});
  if (course(m, "heave", m.series.heave, 1).moves())
    columns.push_back({"heave", "m", "heave", ColumnKind::translation, Rest::zero, excursion[1]});
  if (course(m, "roll", m.series.roll, degree).moves())
    columns.push_back({"roll", "deg", "roll", ColumnKind::rotation, Rest::zero});
  return columns;
}

}  // namespace seiche::solver
