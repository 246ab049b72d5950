#include "render/palette.hpp"

namespace seiche::render {

Palette palette(const std::string& background) {
  if (background == "black")
    return {.paper = {0, 0, 0},
            .ink = {232, 232, 232},
            .outline = {214, 214, 214},
            .shade = {30, 31, 33},
            .grid = {52, 53, 56},
            .curve = line_colours[4],
            .references = {{{255, 255, 255}, line_colours[3], line_colours[2]}}};
  return {.paper = {255, 255, 255},
          .ink = {34, 34, 34},
          .outline = {64, 64, 64},
          .shade = {240, 241, 243},
          .grid = {222, 224, 227},
          .curve = line_colours[0],
          .references = {{{40, 40, 40}, line_colours[1], line_colours[2]}}};
}

}  // namespace seiche::render
