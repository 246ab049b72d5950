#pragma once
#include <vector>

#include "solver/column.hpp"
#include "solver/frame.hpp"
#include "solver/motion/course.hpp"
#include "solver/parameters.hpp"

namespace seiche::solver {

/// The tank's motion in the lab. A point r of the tank is at pivot + (surge, heave) + R(roll) (r - pivot), R the
/// rotation about z from x towards y.
class Motion {
 public:
  explicit Motion(const Parameters::Motion& m);

  Jet surge(double t) const { return surge_.at(t); }  ///< along x [m, m/s, m/s^2]
  Jet heave(double t) const { return heave_.at(t); }  ///< along y, the same
  Jet roll(double t) const { return roll_.at(t); }    ///< [rad, rad/s, rad/s^2]

  bool rolls() const { return roll_.moves(); }
  double pivot_x() const { return pivot_x_; }  ///< [m]
  double pivot_y() const { return pivot_y_; }

  /// Half the vorticity in the lab of liquid that has kept what it had at t = 0: none if it was at rest, that of the
  /// tank if it moved with it [rad/s].
  double spin_of_liquid() const { return spin_; }

  /// Whether the tank's velocity jumps at t = 0, the liquid being at rest in the lab.
  bool jumps() const;

  /// No point of the tank within `reach` [m] of the pivot is ever faster [m/s].
  double fastest(double reach = 0) const;

  /// No point of the box [low, high] is ever farther from where it is at (surge, heave, roll) = 0, on either axis [m].
  Double3 extent(const Double3& low, const Double3& high) const;

  TankPose pose(double t) const;

  /// Appends the value of each of motion_columns at t: [m], [m], [degrees].
  void append(double t, std::vector<double>& values) const;

 private:
  Course surge_, heave_, roll_;
  double pivot_x_, pivot_y_;
  double spin_;
  bool impulsive_;
};

/// The columns of what the motion moves, of surge, heave and roll.
/// @param excursion scale of the first two on each axis [m]
std::vector<Column> motion_columns(const Parameters::Motion& m, const Double3& excursion);

}  // namespace seiche::solver
