#pragma once
#include <vector>

#include "solver/column.hpp"
#include "solver/frame.hpp"
#include "solver/motion/course.hpp"
#include "solver/parameters.hpp"

namespace seiche::solver {

/// The tank's motion in the lab, in six degrees of freedom. It is turned by roll, then by pitch and yaw about the axes
/// that stay in the lab: R = R_y(yaw) R_x(pitch) R_z(roll), and displaced by (surge, heave, sway).
class Motion {
 public:
  explicit Motion(const Parameters::Motion& m);

  /// One degree of freedom at t [m; rad of a rotation] with its rate and acceleration.
  Jet at(DegreeOfFreedom f, double t) const { return course(f).at(t); }
  bool moves(DegreeOfFreedom f) const { return course(f).moves(); }
  bool rotates() const;

  RigidState state(double t) const;

  /// Half the vorticity in the lab of liquid that has kept what it had at t = 0: none if it was at rest, that of the
  /// tank if it moved with it; in the lab's axes [rad/s].
  const Eigen::Vector3d& spin_of_liquid() const { return spin_; }

  /// Whether the tank's velocity jumps at t = 0, the liquid being at rest in the lab.
  bool jumps() const;

  /// No point of the tank within `reach` [m] of the pivot is ever faster [m/s].
  double fastest(double reach = 0) const;
  /// The same of accelerations, the centripetal one included [m/s^2].
  double greatest_acceleration(double reach = 0) const;

  /// No point of the box [low, high] is ever farther from where it is without motion, on each axis [m].
  Double3 extent(const Double3& low, const Double3& high) const;

  /// Appends the value of each of motion_columns at t: [m], of rotations [degrees].
  void append(double t, std::vector<double>& values) const;

 private:
  const Course& course(DegreeOfFreedom f) const { return courses_[static_cast<std::size_t>(f)]; }

  std::vector<Course> courses_;  ///< of each degree of freedom
  Eigen::Vector3d pivot_;
  bool impulsive_;
  Eigen::Vector3d spin_ = Eigen::Vector3d::Zero();
};

/// The columns of what the motion moves.
/// @param excursion scale of translations along each axis [m]
std::vector<Column> motion_columns(const Parameters::Motion& m, const Double3& excursion);

}  // namespace seiche::solver
