#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace seiche::render {

using Rgb = std::array<std::uint8_t, 3>;

/// A map from [0, 1] to colours. Values beyond are given the end's colour.
class ColourMap {
 public:
  /// viridis | cividis | cool-warm | turbo. Throws std::invalid_argument on any other name.
  explicit ColourMap(const std::string& name);

  Rgb operator()(double t) const;

 private:
  std::span<const std::uint32_t> table_;
};

std::vector<std::string> colour_map_names();

}  // namespace seiche::render
