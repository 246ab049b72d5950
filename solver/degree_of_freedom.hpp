#pragma once
#include <array>
#include <string_view>

namespace seiche {

/// A degree of freedom of the tank as a rigid body.
enum class DegreeOfFreedom { surge, heave, sway, roll, pitch, yaw };

/// What scenes, motion files and sensor columns call one, and what it is.
struct DegreeOfFreedomRow {
  DegreeOfFreedom value;
  std::string_view name;
  bool rotation;  ///< about its axis, counter-clockwise seen from the axis' tip; else along it
  int tank_axis;  ///< with motion.axes = "tank": 0, 1, 2: x, y, z
  int ship_axis;  ///< with motion.axes = "ship": 0, 1, 2: forward, port, up
  std::string_view help;

  /// Of its values in scenes, motion files and sensor columns.
  constexpr std::string_view unit() const { return rotation ? "deg" : "m"; }
};

inline constexpr std::size_t number_of_degrees_of_freedom = 6;

/// In the order of the enumerators.
inline constexpr std::array<DegreeOfFreedomRow, number_of_degrees_of_freedom> degrees_of_freedom{{
    {DegreeOfFreedom::surge, "surge", false, 0, 0, "along x; of a ship: forward"},
    {DegreeOfFreedom::heave, "heave", false, 1, 2, "along y, upwards; of a ship: up"},
    {DegreeOfFreedom::sway, "sway", false, 2, 1, "along z; of a ship: to port"},
    {DegreeOfFreedom::roll, "roll", true, 2, 0, "about z, from x towards y; of a ship: about forward, port side up"},
    {DegreeOfFreedom::pitch, "pitch", true, 0, 1, "about x, from y towards z; of a ship: about port, bow down"},
    {DegreeOfFreedom::yaw, "yaw", true, 1, 2, "about y, from z towards x; of a ship: about up, bow to port"},
}};

constexpr const DegreeOfFreedomRow& row(DegreeOfFreedom f) { return degrees_of_freedom[static_cast<std::size_t>(f)]; }

constexpr std::string_view name(DegreeOfFreedom f) { return row(f).name; }

}  // namespace seiche
