#pragma once
#include <string>

#include "solver/choice.hpp"

namespace seiche {

/// The plane axis = at [m] in which a 3-D tank is cut for a 2-D run. Axis y isn't one: gravity lies across that plane.
struct SectionPlane {
  Axis axis = Axis::z;
  double at = 0;

  bool operator==(const SectionPlane&) const = default;
};

/// From text as in "x=0" or "z = 0.1". Throws BadParameters.
SectionPlane parse_section(const std::string& text);

/// The same text, as in "x=0".
std::string text_of(const SectionPlane& plane);

}  // namespace seiche
