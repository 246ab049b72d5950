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
  int axis;        ///< 0, 1, 2: x, y, z of the tank
  bool rotation;   ///< about the axis, counter-clockwise seen from its tip; else along it
  bool in_scenes;  ///< whether scenes, motion files and run.json have it
  std::string_view help;

  /// Of its values in scenes, motion files and sensor columns.
  constexpr std::string_view unit() const { return rotation ? "deg" : "m"; }
  /// Whether it keeps the plane of x and y: those that a 2-D run has.
  constexpr bool in_plane() const { return rotation == (axis == 2); }
};

inline constexpr std::size_t number_of_degrees_of_freedom = 6;

/// In the order of the enumerators.
inline constexpr std::array<DegreeOfFreedomRow, number_of_degrees_of_freedom> degrees_of_freedom{{
    {DegreeOfFreedom::surge, "surge", 0, false, true, "along x"},
    {DegreeOfFreedom::heave, "heave", 1, false, true, "along y, upwards"},
    {DegreeOfFreedom::sway, "sway", 2, false, false, "along z"},
    {DegreeOfFreedom::roll, "roll", 2, true, true, "about the pivot from x towards y"},
    {DegreeOfFreedom::pitch, "pitch", 0, true, false, "about the pivot from y towards z"},
    {DegreeOfFreedom::yaw, "yaw", 1, true, false, "about the pivot from z towards x"},
}};

constexpr const DegreeOfFreedomRow& row(DegreeOfFreedom f) { return degrees_of_freedom[static_cast<std::size_t>(f)]; }

constexpr std::string_view name(DegreeOfFreedom f) { return row(f).name; }

}  // namespace seiche
