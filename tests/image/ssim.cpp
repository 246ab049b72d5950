#include "tests/image/ssim.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace seiche::test {
namespace {

constexpr int side = 8, step = 4, tile = 32;

double window(const render::Image& a, const render::Image& b, int x0, int y0, int channel) {
  constexpr double n = side * side, c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
  double sum_a = 0, sum_b = 0, sum_aa = 0, sum_bb = 0, sum_ab = 0;
  for (int y = y0; y < y0 + side; ++y)
    for (int x = x0; x < x0 + side; ++x) {
      const auto at = 4 * static_cast<std::size_t>(y * a.width + x) + static_cast<std::size_t>(channel);
      const double p = a.rgba[at], q = b.rgba[at];
      sum_a += p;
      sum_b += q;
      sum_aa += p * p;
      sum_bb += q * q;
      sum_ab += p * q;
    }
  const double mean_a = sum_a / n, mean_b = sum_b / n;
  const double var_a = sum_aa / n - mean_a * mean_a, var_b = sum_bb / n - mean_b * mean_b;
  const double covariance = sum_ab / n - mean_a * mean_b;
  return (2 * mean_a * mean_b + c1) * (2 * covariance + c2) /
         ((mean_a * mean_a + mean_b * mean_b + c1) * (var_a + var_b + c2));
}

}  // namespace

Similarity similarity(const render::Image& a, const render::Image& b) {
  if (a.width != b.width || a.height != b.height) throw std::invalid_argument("pictures of different sizes");
  struct Mean {
    double sum = 0;
    int count = 0;
    double value() const { return count ? sum / count : 1; }
  };
  const auto across = static_cast<std::size_t>(a.width / tile) + 1;
  std::vector<Mean> tiles(across * (static_cast<std::size_t>(a.height / tile) + 1));
  const auto tile_at = [&](int x, int y) {
    return static_cast<std::size_t>(y / tile) * across + static_cast<std::size_t>(x / tile);
  };
  Mean all;
  for (int y = 0; y + side <= a.height; y += step)
    for (int x = 0; x + side <= a.width; x += step) {
      double least = 1;
      for (int channel = 0; channel < 4; ++channel) least = std::min(least, window(a, b, x, y, channel));
      for (Mean* mean : {&all, &tiles[tile_at(x, y)]}) {
        mean->sum += least;
        ++mean->count;
      }
    }
  Similarity found{all.value(), 1};
  for (const Mean& mean : tiles) found.least = std::min(found.least, mean.value());
  return found;
}

}  // namespace seiche::test
