#pragma once
#include <cstdint>
#include <vector>

namespace seiche::render {

/// A picture in memory: 8-bit RGBA (not premultiplied), rows from the top, no padding.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

}  // namespace seiche::render
