#include "solver/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;

/// The rotations that an orientation is made of, from the first that turns the tank to the last.
constexpr std::array rotations{DegreeOfFreedom::roll, DegreeOfFreedom::pitch, DegreeOfFreedom::yaw};

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

Course course_of(const Parameters::Motion& m, const DegreeOfFreedomRow& row) {
  Course result(m.ramp);
  for (const Parameters::Harmonic& h : harmonics(m))
    if (h.of == row.value) result.add(h.amplitude * unit_of(row), h.frequency, h.phase * degree);
  if (m.type == MotionType::file && !m.series[row.value].empty()) {
    std::vector<double> values = m.series[row.value];
    for (double& value : values) value *= unit_of(row);
    result.follow(Spline(m.series.time, std::move(values)));
  }
  return result;
}

}  // namespace

Motion::Motion(const Parameters::Motion& m) : pivot_(m.pivot_x, m.pivot_y, 0), impulsive_(m.start == Start::impulsive) {
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) courses_.push_back(course_of(m, row));
  if (impulsive_) return;
  const RigidState start = state(0);
  spin_ = start.orientation * start.omega;
}

bool Motion::rotates() const {
  return std::any_of(rotations.begin(), rotations.end(), [&](DegreeOfFreedom f) { return moves(f); });
}

/// With R = R_k ... R_1 the angular velocity in the tank's axes is, taken from the last rotation to the first,
///   w <- R_j^T w + q_j' e_j,   w' <- R_j^T w' + q_j'' e_j - q_j' e_j x (R_j^T w),
/// q_j the angle about the axis e_j.
RigidState Motion::state(double t) const {
  RigidState result;
  result.pivot = pivot_;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (row.rotation || !moves(row.value)) continue;
    const Jet jet = at(row.value, t);
    result.displacement[row.axis] = jet.value;
    result.velocity[row.axis] = jet.rate;
    result.acceleration[row.axis] = jet.acceleration;
  }
  if (!rotates()) return result;
  for (auto f = rotations.rbegin(); f != rotations.rend(); ++f) {
    if (!moves(*f)) continue;
    const Jet angle = at(*f, t);
    const Vector3d axis = Vector3d::Unit(row(*f).axis);
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
    (row.rotation ? rate : velocity[row.axis]) += course(row.value).fastest();
  return velocity.norm() + reach * rate;
}

/// Of rotations one after another |alpha| is at most the sum of |q_i''| + the sum over pairs of |q_i' q_j'|.
double Motion::greatest_acceleration(double reach) const {
  Vector3d translation = Vector3d::Zero();
  double rate = 0, alpha = 0;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    const Course& moved = course(row.value);
    if (!row.rotation) {
      translation[row.axis] = moved.greatest_acceleration();
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
    if (!row.rotation) translation[row.axis] = course(row.value).greatest();
  for (int a = 0; a < 3; ++a) farthest[a] = std::max(std::abs(low[a] - pivot_[a]), std::abs(high[a] - pivot_[a]));
  for (const DegreeOfFreedom f : rotations) {
    const double angle = std::min(course(f).greatest(), std::numbers::pi);
    const double across = std::sin(std::min(angle, std::numbers::pi / 2)), along = 1 - std::cos(angle);
    const int a = (row(f).axis + 1) % 3, b = (row(f).axis + 2) % 3;
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
                       row.rotation ? 1 : excursion[static_cast<std::size_t>(row.axis)]});
  }
  return columns;
}

}  // namespace seiche::solver
