#pragma once
#include <array>

#include "render/picture/colour_map.hpp"

namespace seiche::render {

/// Colours that differ for the colour-blind too: M. Okabe, K. Ito, Color Universal Design, 2008; its yellow is left
/// out, being too pale for a line on white.
constexpr std::array<Rgb, 6> line_colours{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {0, 0, 0}}};

/// A picture's colours but for its colour map.
struct Palette {
  Rgb background, foreground, outline, shade;
  Rgb grid, curve;                ///< of the curves under the picture
  std::array<Rgb, 3> references;  ///< of the series beside them, in turn
  std::array<Rgb, 9> runs;        ///< of the curves of several runs
};

/// Of Look::background.
Palette palette(Background background);

/// The same for a picture of several runs: references are greys, which are no run's colour, and differ by their dashes.
Palette palette_of_several(Background background);

}  // namespace seiche::render
