#pragma once
#include <string>

#include "render/image.hpp"
#include "render/look.hpp"

namespace seiche::test {

/// Processors differ by 1/255 here and there, and in a sample of an edge; a wrong picture is far below.
constexpr double least_mean = 0.99, least_tile = 0.9;

inline render::Look sized(int width, int height) {
  render::Look look;
  look.width = width;
  look.height = height;
  return look;
}

/// Fails where a picture differs from baseline/name.png. To take it over as the new baseline, look at it and copy it
/// there.
void expect_baseline(const std::string& name, const render::Image& image);

}  // namespace seiche::test
