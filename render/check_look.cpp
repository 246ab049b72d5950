#include "render/check_look.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>

#include "render/curves/curve_choice.hpp"
#include "render/picture/colour_map.hpp"
#include "render/picture/quantity.hpp"
#include "render/picture/range.hpp"

namespace seiche::render {

void check_look(const Look& look) {
  const auto among = [](const char* key, const std::string& value, std::initializer_list<const char*> names) {
    if (std::find(names.begin(), names.end(), value) != names.end()) return;
    std::string all;
    for (const char* name : names) all += all.empty() ? name : fmt::format(", {}", name);
    throw std::invalid_argument(fmt::format("'{}' is no {}; choose one of {}", value, key, all));
  };
  if (look.width < 64 || look.height < 64 || look.width > 8192 || look.height > 8192)
    throw std::invalid_argument(
        fmt::format("{} x {} is no size for a picture; give 64 to 8192 pixels each way", look.width, look.height));
  quantity_of(look.quantity);
  ColourMap{look.colour_map};
  among("background", look.background, {"white", "black", "transparent"});
  among("style", look.style, {"disc", "dot", "smooth"});
  if (look.style == "smooth" && !classes_of(quantity_of(look.quantity)).empty())
    throw std::invalid_argument(fmt::format(
        "style 'smooth' draws means of numbers, and '{}' is none; choose another quantity, or style disc or dot",
        look.quantity));
  among("view", look.view, {"tank", "lab"});
  parse_range(look.range);
  named_curves(look.curves);
}

void check_dimension(const Look& look, int dimension) {
  if (dimension == 2) return;
  const auto refuse = [](const char* what, const char* instead) {
    throw std::invalid_argument(fmt::format("{} is for 2-D runs, and this one is 3-D; set it to {}", what, instead));
  };
  if (look.show_arrows) refuse("look.arrows = true", "false");
  if (look.show_surface_line) refuse("look.surface_line = true", "false");
  if (look.style == "smooth") refuse("look.style = 'smooth'", "disc or dot");
}

}  // namespace seiche::render
