#include "render/liquid/smooth_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::render {
namespace {

constexpr double radius = 2.2;  // of the bell [l0]: wide enough that the lattice of particles doesn't show
constexpr double above_rim = 1.25;

std::size_t nodes(double size, double step) { return static_cast<std::size_t>(std::ceil(size / step - 1e-9)) + 1; }

}  // namespace

SmoothField::SmoothField(const RunInfo& run, double step)
    : length_(run.tank.high()[0]),
      height_(run.tank.high()[1] * (run.closed ? 1 : above_rim)),
      reach_(std::max(radius * run.spacing, 2 * step)),
      // The bell (1 - (r/h)^2)^2 has the integral pi h^2 / 3.
      volume_(run.spacing * run.spacing * 3 / (std::numbers::pi * reach_ * reach_)),
      closed_(run.closed),
      columns_(nodes(length_, step)),
      rows_(nodes(height_, step)),
      dx_(length_ / static_cast<double>(columns_ - 1)),
      dy_(height_ / static_cast<double>(rows_ - 1)),
      fraction_(columns_ * rows_),
      mean_(columns_ * rows_) {}

void SmoothField::splat(double x, double y, double value) {
  const auto first = [&](double at, double d) { return static_cast<long>(std::ceil(std::max(at - reach_, 0.0) / d)); };
  const auto last = [&](double at, double d, std::size_t count) {
    return std::min(static_cast<long>(std::floor((at + reach_) / d)), static_cast<long>(count) - 1);
  };
  const float scale = static_cast<float>(1 / (reach_ * reach_)), volume = static_cast<float>(volume_);
  const long left = first(x, dx_), right = last(x, dx_, columns_);
  for (long j = first(y, dy_), top = last(y, dy_, rows_); j <= top; ++j) {
    const float off = static_cast<float>(static_cast<double>(j) * dy_ - y), rest = 1 - off * off * scale;
    float* fraction = fraction_.data() + j * static_cast<long>(columns_);
    float* mean = mean_.data() + j * static_cast<long>(columns_);
    for (long i = left; i <= right; ++i) {
      const float along = static_cast<float>(static_cast<double>(i) * dx_ - x);
      const float bell = std::max(rest - along * along * scale, 0.0f), weight = volume * bell * bell;
      fraction[i] += weight;
      mean[i] += weight * static_cast<float>(value);
    }
  }
}

void SmoothField::take(const Frame& frame, Quantity quantity) {
  std::fill(fraction_.begin(), fraction_.end(), 0.0f);
  std::fill(mean_.begin(), mean_.end(), 0.0f);
  for (std::size_t p = 0; p < frame.size(); ++p) {
    if (frame.kind[p] != Kind::fluid) continue;
    const double x = frame.position[p][0], y = frame.position[p][1], value = value_of(quantity, frame, p);
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(value)) continue;
    if (x < -reach_ || x > length_ + reach_ || y < -reach_ || y > height_ + reach_) continue;
    // Mirrored in one side or, near a corner, in both.
    const double xs[] = {x, x < reach_ ? -x : 2 * length_ - x};
    const double ys[] = {y, y < reach_ ? -y : 2 * height_ - y};
    const int columns = x < reach_ || x > length_ - reach_ ? 2 : 1;
    const int rows = y < reach_ || (closed_ && y > height_ - reach_) ? 2 : 1;
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) splat(xs[i], ys[j], value);
  }
  for (std::size_t k = 0; k < mean_.size(); ++k) mean_[k] = fraction_[k] > 0 ? mean_[k] / fraction_[k] : 0;
}

double SmoothField::fraction_at(double x, double y) const {
  const double column = x / dx_, row = y / dy_;
  if (!(column >= 0 && row >= 0 && x <= length_ && y <= height_)) return 0;
  const std::size_t i = std::min(static_cast<std::size_t>(column), columns_ - 2);
  const std::size_t j = std::min(static_cast<std::size_t>(row), rows_ - 2);
  const double a = column - static_cast<double>(i), b = row - static_cast<double>(j);
  const float* at = fraction_.data() + j * columns_ + i;
  return (1 - b) * ((1 - a) * at[0] + a * at[1]) + b * ((1 - a) * at[columns_] + a * at[columns_ + 1]);
}

}  // namespace seiche::render
