#pragma once
#include <vector>

#include "render/picture/boxes.hpp"

namespace seiche::render {

/// Texts around curves are smaller than the picture's by this factor.
constexpr double curve_font = 0.88;

/// The first time's label and the name of the times stand this far apart, in font heights.
constexpr double name_gap = 0.6;

/// Height of the strip that curves take under a picture: about a quarter of it. 0 when the picture is too narrow for
/// them.
double curve_strip(const Needs& needs, double font);

/// The curves side by side in the strip.
std::vector<CurveBoxes> lay_out_curves(const std::vector<CurveNeeds>& needs, const Box& strip, double font);

}  // namespace seiche::render
