#pragma once
#include <array>
#include <cstdint>
#include <span>

#include "render/look.hpp"

namespace seiche::render {

using Rgb = std::array<std::uint8_t, 3>;

/// A map from [0, 1] to colours. Values beyond are given the end's colour.
class ColourMap {
 public:
  explicit ColourMap(ColourMapName name);

  Rgb operator()(double t) const;

 private:
  std::span<const std::uint32_t> table_;
};

}  // namespace seiche::render
