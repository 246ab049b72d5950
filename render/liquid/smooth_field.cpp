#include "render/liquid/smooth_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "render/picture/tank_section.hpp"

namespace seiche::render {
namespace {

constexpr double radius = 2.2;  // of the bell [l0]: wide enough that the lattice of particles doesn't show
constexpr double above_rim = 1.25;
/// Where less of a bell lies inside the tank it tells nothing.
constexpr double least_open = 0.1;

std::size_t nodes(double size, double step) { return static_cast<std::size_t>(std::ceil(size / step - 1e-9)) + 1; }

}  // namespace

SmoothField::SmoothField(const RunInfo& run, double step)
    : left_(run.tank.low()[0]),
      bottom_(run.tank.low()[1]),
      length_(run.tank.size()[0]),
      height_(run.tank.size()[1] * (run.closed ? 1 : above_rim)),
      reach_(std::max(radius * run.spacing, 2 * step)),
      columns_(nodes(length_, step)),
      rows_(nodes(height_, step)),
      dx_(length_ / static_cast<double>(columns_ - 1)),
      dy_(height_ / static_cast<double>(rows_ - 1)),
      fraction_(columns_ * rows_),
      mean_(columns_ * rows_),
      open_(columns_ * rows_) {
  // Each node's cell counts as liquid as far as it lies inside.
  const TankSection section(run);
  const auto margin = static_cast<long>(std::ceil(reach_ / std::min(dx_, dy_)));
  for (long j = -margin; j < static_cast<long>(rows_) + margin; ++j) {
    constexpr int lines = 4;
    std::array<std::vector<double>, lines> crossings;
    for (int k = 0; k < lines; ++k)
      crossings[static_cast<std::size_t>(k)] =
          section.crossings(bottom_ + (static_cast<double>(j) + (k + 0.5) / lines - 0.5) * dy_);
    for (long i = 0; i < static_cast<long>(columns_); ++i) {
      const double from = left_ + (static_cast<double>(i) - 0.5) * dx_, to = from + dx_;
      double inside = 0;
      for (const auto& line : crossings)
        for (std::size_t c = 0; c + 1 < line.size(); c += 2)
          inside += std::max(0.0, std::min(line[c + 1], to) - std::max(line[c], from));
      if (inside > 0)
        splat(left_ + static_cast<double>(i) * dx_, bottom_ + static_cast<double>(j) * dy_, inside / lines * dy_, 0);
    }
  }
  open_.swap(fraction_);
  // The bell (1 - (r/h)^2)^2 has the integral pi h^2 / 3.
  for (float& open : open_) {
    const double share = open * 3 / (std::numbers::pi * reach_ * reach_);
    open = share < least_open ? 0 : static_cast<float>(1 / share);
  }
  volume_ = run.spacing * run.spacing * 3 / (std::numbers::pi * reach_ * reach_);
}

void SmoothField::splat(double x, double y, double volume, double value) {
  x -= left_;
  y -= bottom_;
  const auto first = [&](double at, double d) { return static_cast<long>(std::ceil(std::max(at - reach_, 0.0) / d)); };
  const auto last = [&](double at, double d, std::size_t count) {
    return std::min(static_cast<long>(std::floor((at + reach_) / d)), static_cast<long>(count) - 1);
  };
  const float scale = static_cast<float>(1 / (reach_ * reach_)), whole = static_cast<float>(volume);
  const long left = first(x, dx_), right = last(x, dx_, columns_);
  for (long j = first(y, dy_), top = last(y, dy_, rows_); j <= top; ++j) {
    const float off = static_cast<float>(static_cast<double>(j) * dy_ - y), rest = 1 - off * off * scale;
    float* fraction = fraction_.data() + j * static_cast<long>(columns_);
    float* mean = mean_.data() + j * static_cast<long>(columns_);
    for (long i = left; i <= right; ++i) {
      const float along = static_cast<float>(static_cast<double>(i) * dx_ - x);
      const float bell = std::max(rest - along * along * scale, 0.0f), weight = whole * bell * bell;
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
    if (std::abs(x - left_ - 0.5 * length_) > 0.5 * length_ + reach_) continue;
    if (std::abs(y - bottom_ - 0.5 * height_) > 0.5 * height_ + reach_) continue;
    splat(x, y, volume_, value);
  }
  for (std::size_t k = 0; k < mean_.size(); ++k) {
    mean_[k] = fraction_[k] > 0 ? mean_[k] / fraction_[k] : 0;
    fraction_[k] *= open_[k];
  }
}

double SmoothField::fraction_at(double x, double y) const {
  const double column = (x - left_) / dx_, row = (y - bottom_) / dy_;
  if (!(column >= 0 && row >= 0 && x - left_ <= length_ && y - bottom_ <= height_)) return 0;
  const std::size_t i = std::min(static_cast<std::size_t>(column), columns_ - 2);
  const std::size_t j = std::min(static_cast<std::size_t>(row), rows_ - 2);
  const double a = column - static_cast<double>(i), b = row - static_cast<double>(j);
  const float* at = fraction_.data() + j * columns_ + i;
  return (1 - b) * ((1 - a) * at[0] + a * at[1]) + b * ((1 - a) * at[columns_] + a * at[columns_ + 1]);
}

}  // namespace seiche::render
