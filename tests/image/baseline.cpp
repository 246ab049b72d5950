#include "tests/image/baseline.hpp"

#include <gtest/gtest.h>

#include "render/outputs.hpp"
#include "tests/image/ssim.hpp"
#include "tests/unit/render/read_png.hpp"

namespace seiche::test {

void expect_baseline(const std::string& name, const render::Image& image) {
  const auto actual = std::filesystem::path(ACTUAL) / (name + ".png");
  const auto baseline = std::filesystem::path(BASELINES) / (name + ".png");
  render::write_png(actual, image, {});
  const auto found = similarity(image, read_png(baseline));
  EXPECT_GE(found.mean, least_mean) << "look at " << actual << " beside " << baseline;
  EXPECT_GE(found.least, least_tile) << "look at " << actual << " beside " << baseline;
}

}  // namespace seiche::test
