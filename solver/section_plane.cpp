#include "solver/section_plane.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "solver/errors.hpp"

namespace seiche {

SectionPlane parse_section(const std::string& text) {
  std::string packed = text;
  std::erase(packed, ' ');
  const char axis = packed.empty() ? '?' : packed[0];
  char* end = nullptr;
  const bool begins = packed.size() > 2 && (axis == 'x' || axis == 'y' || axis == 'z') && packed[1] == '=';
  const double at = begins ? std::strtod(packed.c_str() + 2, &end) : 0;
  if (!begins || *end != '\0' || !std::isfinite(at))
    throw BadParameters(fmt::format("section = \"{}\" is no plane; give one as in \"z=0\" or \"x=0.1\" [m]", text));
  if (axis == 'y')
    throw BadParameters(fmt::format(
        "section = \"{}\" is level, so that gravity lies across it; take a plane of x or of z, as in \"z=0\"", text));
  return {axis == 'x' ? Axis::x : Axis::z, at};
}

std::string text_of(const SectionPlane& plane) { return fmt::format("{}={}", name(plane.axis), plane.at); }

}  // namespace seiche
