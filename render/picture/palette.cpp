#include "render/picture/palette.hpp"

namespace seiche::render {
namespace {

// Six of Okabe and Ito's, then three that are neither too pale nor too dark on the paper and, like all, differ for the
// colour-blind; on white those are of P. Tol's scheme "muted" (SRON/EPS/TN/09-002).
std::array<Rgb, 9> run_colours(Rgb seventh, Rgb eighth, Rgb ninth) {
  constexpr Rgb orange{230, 159, 0};
  const auto& line = line_colours;
  return {line[0], line[1], line[2], line[3], line[4], orange, seventh, eighth, ninth};
}

}  // namespace

Palette palette(Background background) {
  if (background == Background::black)
    return {.background = {0, 0, 0},
            .foreground = {232, 232, 232},
            .outline = {214, 214, 214},
            .shade = {30, 31, 33},
            .grid = {52, 53, 56},
            .curve = line_colours[4],
            .references = {{{255, 255, 255}, line_colours[3], line_colours[2]}},
            .runs = run_colours({240, 228, 66}, {255, 190, 200}, {150, 75, 0})};
  return {.background = {255, 255, 255},
          .foreground = {34, 34, 34},
          .outline = {64, 64, 64},
          .shade = {240, 241, 243},
          .grid = {222, 224, 227},
          .curve = line_colours[0],
          .references = {{{40, 40, 40}, line_colours[1], line_colours[2]}},
          .runs = run_colours({136, 34, 85}, {153, 153, 51}, {51, 34, 136})};
}

Palette palette_of_several(Background background) {
  Palette colours = palette(background);
  if (background == Background::black)
    colours.references = {{{255, 255, 255}, {185, 185, 185}, {140, 140, 140}}};
  else
    colours.references = {{{40, 40, 40}, {95, 95, 95}, {135, 135, 135}}};
  return colours;
}

}  // namespace seiche::render
