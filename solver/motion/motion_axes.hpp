#pragma once
#include <array>

#include "solver/degree_of_freedom.hpp"
#include "solver/parameters.hpp"

namespace seiche {

/// An axis of the tank, or the direction against it.
struct TankAxis {
  int axis = 0;  ///< 0, 1, 2: x, y, z
  int sign = 1;

  bool operator==(const TankAxis&) const = default;
};

/// The axes of the frame that the motion is told in: x, y, z of the tank, or forward, port, up of a ship, which stand
/// in the tank as tank_x says. Both frames are right-handed, and up is the tank's y.
constexpr std::array<TankAxis, 3> axes_of(const Parameters::Motion& m) {
  if (m.axes == MotionAxes::tank) return {{{0, 1}, {1, 1}, {2, 1}}};
  if (m.tank_x == TankX::port) return {{{2, 1}, {0, 1}, {1, 1}}};
  return {{{0, 1}, {2, -1}, {1, 1}}};
}

/// The axis of that frame that a degree of freedom is along, or about: 0, 1, 2.
constexpr int frame_axis(const DegreeOfFreedomRow& row, const Parameters::Motion& m) {
  return m.axes == MotionAxes::tank ? row.tank_axis : row.ship_axis;
}

/// The axis of the tank that a degree of freedom is along, or about.
constexpr TankAxis axis_of(const DegreeOfFreedomRow& row, const Parameters::Motion& m) {
  return axes_of(m)[static_cast<std::size_t>(frame_axis(row, m))];
}

/// Whether it keeps the plane of x and y: those three that a 2-D run has.
constexpr bool in_plane(const DegreeOfFreedomRow& row, const Parameters::Motion& m) {
  return row.rotation == (axis_of(row, m).axis == 2);
}

/// The rotation about an axis of the motion's own frame: 0, 1, 2.
constexpr DegreeOfFreedom rotation_about(int axis, const Parameters::Motion& m) {
  for (const DegreeOfFreedomRow& row : degrees_of_freedom)
    if (row.rotation && frame_axis(row, m) == axis) return row.value;
  return DegreeOfFreedom::roll;
}

}  // namespace seiche
