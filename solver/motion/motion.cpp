#include "solver/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/motion/record.hpp"

namespace seiche::solver {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

Vector3d unit_vector(const TankAxis& axis) { return axis.sign * Vector3d::Unit(axis.axis); }

double unit_of(const DegreeOfFreedomRow& row) { return row.rotation ? degree : 1; }

// The terms of a motion that is no file: a single one stands for itself.
std::vector<Parameters::Harmonic> harmonics(const Parameters::Motion& m) {
  switch (m.type) {
    case MotionType::harmonic:
      return {m.harmonic};
    case MotionType::harmonics:
      return m.harmonics;
    case MotionType::none:
    case MotionType::file:
      break;
  }
  return {};
}

/// Whether a record of it is missing, or 0 throughout, as ships' records of all six may be.
bool is_at_rest(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double value) { return value == 0; });
}

Course course_of(const Parameters::Motion& m, const DegreeOfFreedomRow& row) {
  Course result(m.ramp);
  for (const Parameters::Harmonic& h : harmonics(m))
    if (h.of == row.value) result.add(h.amplitude * unit_of(row), h.frequency, h.phase * degree);
  if (m.type == MotionType::file && !is_at_rest(m.series[row.value])) {
    const std::vector<double>& record = m.series[row.value];
    std::vector<double> values = m.cutoff > 0 ? smoothed(m.series.time, record, m.cutoff) : record;
    for (double& value : values) value *= unit_of(row);
    result.follow({Spline(m.series.time, std::move(values)), m.from, m.hold});
  }
  return result;
}

}  // namespace

Motion::Motion(const Parameters::Motion& m)
    : rotations_{rotation_about(2, m), rotation_about(1, m), rotation_about(0, m)},
      pivot_(m.pivot_x, m.pivot_y, m.pivot_z),
      impulsive_(m.start == Start::impulsive) {
  if (m.rotation_order == RotationOrder::xyz) std::reverse(rotations_.begin(), rotations_.end());
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    courses_.push_back(course_of(m, row));
    axes_.push_back(axis_of(row, m));
  }
  if (impulsive_) return;
  const RigidState start = state(0);
  spin_ = start.orientation * start.omega;
}

bool Motion::rotates() const {
  return std::any_of(rotations_.begin(), rotations_.end(), [&](DegreeOfFreedom f) { return moves(f); });
}

/// With R = R_1 R_2 R_3 the angular velocity in the tank's axes is, taken from the left,
///   w <- R_j^T w + q_j' e_j,   w' <- R_j^T w' + q_j'' e_j - q_j' e_j x (R_j^T w),
/// q_j the angle about the axis e_j.
RigidState Motion::state(double t) const {
  RigidState result;
  result.pivot = pivot_;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (row.rotation || !moves(row.value)) continue;
    const Jet jet = at(row.value, t);
    const auto [k, sign] = axis(row.value);
    result.displacement[k] = sign * jet.value;
    result.velocity[k] = sign * jet.rate;
    result.acceleration[k] = sign * jet.acceleration;
  }
  if (!rotates()) return result;
  for (const DegreeOfFreedom f : rotations_) {
    if (!moves(f)) continue;
    const Jet angle = at(f, t);
    const Vector3d axis = unit_vector(axes_[static_cast<std::size_t>(f)]);
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle.value, axis));
    result.orientation = result.orientation * turn;
    const Vector3d omega = turn.conjugate() * result.omega;
    result.alpha = turn.conjugate() * result.alpha + angle.acceleration * axis - angle.rate * axis.cross(omega);
    result.omega = omega + angle.rate * axis;
  }
  return result;
}

bool Motion::jumps() const {
  const RigidState start = state(0);
  return impulsive_ && !(start.velocity.isZero(0) && start.omega.isZero(0));
}

double Motion::fastest(double reach) const {
  Vector3d velocity = Vector3d::Zero();
  double rate = 0;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    (row.rotation ? rate : velocity[axis(row.value).axis]) += course(row.value).fastest();
  return velocity.norm() + reach * rate;
}

/// Of rotations one after another |alpha| is at most the sum of |q_i''| + the sum over pairs of |q_i' q_j'|.
double Motion::greatest_acceleration(double reach) const {
  Vector3d translation = Vector3d::Zero();
  double rate = 0, alpha = 0;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    const Course& moved = course(row.value);
    if (!row.rotation) {
      translation[axis(row.value).axis] = moved.greatest_acceleration();
      continue;
    }
    alpha += moved.greatest_acceleration() + rate * moved.fastest();
    rate += moved.fastest();
  }
  return translation.norm() + reach * (alpha + rate * rate);
}

Double3 Motion::extent(const Double3& low, const Double3& high) const {
  Vector3d translation = Vector3d::Zero(), rotation = Vector3d::Zero(), farthest;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (!row.rotation) translation[axis(row.value).axis] = course(row.value).greatest();
  for (int a = 0; a < 3; ++a) farthest[a] = std::max(std::abs(low[a] - pivot_[a]), std::abs(high[a] - pivot_[a]));
  // R_3, the rightmost, acts first.
  for (auto last = rotations_.rbegin(); last != rotations_.rend(); ++last) {
    const DegreeOfFreedom f = *last;
    const double angle = std::min(course(f).greatest(), std::numbers::pi);
    const double across = std::sin(std::min(angle, std::numbers::pi / 2)), along = 1 - std::cos(angle);
    const int a = (axis(f).axis + 1) % 3, b = (axis(f).axis + 2) % 3;
    const Vector3d reach = farthest + rotation;
    rotation[a] += along * reach[a] + across * reach[b];
    rotation[b] += along * reach[b] + across * reach[a];
  }
  const Vector3d all = translation + rotation;
  return {all[0], all[1], all[2]};
}

void Motion::append(double t, std::vector<double>& values) const {
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (moves(row.value)) values.push_back(at(row.value, t).value / unit_of(row));
}

std::vector<Column> motion_columns(const Parameters::Motion& m, const Double3& excursion) {
  std::vector<Column> columns;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (!course_of(m, row).moves()) continue;
    const std::string name(row.name);
    columns.push_back({name, std::string(row.unit()), name,
                       row.rotation ? ColumnKind::rotation : ColumnKind::translation, Rest::zero,
                       row.rotation ? 1 : excursion[static_cast<std::size_t>(axis_of(row, m).axis)]});
  }
  return columns;
}

}  // namespace seiche::solver
