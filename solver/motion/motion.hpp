#pragma once
#include <array>
#include <vector>

#include "solver/column.hpp"
#include "solver/frame.hpp"
#include "solver/motion/course.hpp"
#include "solver/motion/motion_axes.hpp"
#include "solver/parameters.hpp"

namespace seiche::solver {

/// The tank's motion in the lab, in six degrees of freedom along and about the axes 1, 2, 3 of its frame, which are
/// those of the tank or of a ship (axes_of). The order zyx turns it by R = R_3 R_2 R_1, of a ship that by yaw, then
/// pitch, then roll, each about the axis as it stands by then; xyz by R = R_1 R_2 R_3.
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
  TankAxis axis(DegreeOfFreedom f) const { return axes_[static_cast<std::size_t>(f)]; }

  std::vector<Course> courses_;                 ///< of each degree of freedom
  std::vector<TankAxis> axes_;                  ///< of each
  std::array<DegreeOfFreedom, 3> rotations_{};  ///< R is their product, the first one's rotation leftmost
  Eigen::Vector3d pivot_;
  bool impulsive_;
  Eigen::Vector3d spin_ = Eigen::Vector3d::Zero();
};

/// The columns of what the motion moves.
/// @param excursion scale of translations along each axis [m]
std::vector<Column> motion_columns(const Parameters::Motion& m, const Double3& excursion);

}  // namespace seiche::solver
