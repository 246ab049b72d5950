#include "render/check_look.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "render/picture/quantity.hpp"

namespace seiche::render {

void check_picture_size(int width, int height) {
  const auto fits = [](int pixels) { return pixels >= least_size && pixels <= greatest_size; };
  if (!fits(width) || !fits(height))
    throw std::invalid_argument(fmt::format("picture size {} x {} is out of range; give {} to {} pixels each way",
                                            width, height, least_size, greatest_size));
}

void check_look(const Look& look) {
  check_picture_size(look.width, look.height);
  if (look.style == Style::smooth && !classes_of(look.quantity).empty())
    throw std::invalid_argument(fmt::format(
        "style 'smooth' draws means of numbers, which '{}' hasn't; choose another quantity, or style disc or dot",
        name(look.quantity)));
}

void check_dimension(const Look& look, int dimension) {
  if (dimension == 2) return;
  const auto refuse = [](const char* what, const char* instead) {
    throw std::invalid_argument(fmt::format("{} is for 2-D runs, and this one is 3-D; set it to {}", what, instead));
  };
  if (look.show_arrows) refuse("look.arrows = true", "false");
  if (look.show_surface_line) refuse("look.surface_line = true", "false");
  if (look.style == Style::smooth) refuse("look.style = 'smooth'", "disc or dot");
}

}  // namespace seiche::render
