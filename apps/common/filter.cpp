#include "apps/common/filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace seiche::apps {
namespace {

// One pass of the second-order Butterworth high-pass (bilinear transform), at rest on its first sample.
void filter_once(std::vector<double>& z, double rate, double cut) {
  const double k = std::tan(std::numbers::pi * cut / rate), root2 = std::numbers::sqrt2;
  const double b = 1 / (1 + root2 * k + k * k);
  const double a1 = 2 * (k * k - 1) * b, a2 = (1 - root2 * k + k * k) * b;
  const double rest = z.front();
  double x1 = 0, x2 = 0, y1 = 0, y2 = 0;
  for (double& value : z) {
    const double x = value - rest;
    const double y = b * (x - 2 * x1 + x2) - a1 * y1 - a2 * y2;
    x2 = x1, x1 = x, y2 = y1, y1 = y;
    value = y;
  }
}

}  // namespace

std::vector<double> high_pass(const std::vector<double>& y, double rate, double cut) {
  if (y.empty()) return {};
  const std::size_t last = y.size() - 1, pad = std::min(last, static_cast<std::size_t>(3 * rate / cut));
  std::vector<double> z;
  z.reserve(y.size() + 2 * pad);
  for (std::size_t i = pad; i > 0; --i) z.push_back(2 * y.front() - y[i]);
  z.insert(z.end(), y.begin(), y.end());
  for (std::size_t i = 1; i <= pad; ++i) z.push_back(2 * y.back() - y[last - i]);
  for (int pass = 0; pass < 2; ++pass) {
    filter_once(z, rate, cut);
    std::reverse(z.begin(), z.end());
  }
  return {z.begin() + pad, z.end() - pad};
}

Series resampled(const Series& series, double from, double to, double cut) {
  const Series part = series.between(from, to);
  if (part.size() < 50) throw std::runtime_error("a filter needs 50 samples at least");
  const double step = std::max(median_interval(part.t), 0.0005);
  if (1 / step < 4 * cut) throw std::runtime_error("a filter needs 4 samples a period at least");
  const long count = static_cast<long>((part.t.back() - part.t.front()) / step + 1e-6) + 1;
  Series result;
  for (long i = 0; i < count; ++i) {
    result.t.push_back(part.t.front() + static_cast<double>(i) * step);
    result.y.push_back(part.at(result.t.back()));
  }
  return result;
}

double noise(const Series& series, double from, double to, double cut) {
  const Series even = resampled(series, from, to, cut);
  return rms(high_pass(even.y, 1 / median_interval(even.t), cut));
}

Series low_pass(const Series& series, double from, double to, double cut) {
  Series even = resampled(series, from, to, cut);
  const std::vector<double> high = high_pass(even.y, 1 / median_interval(even.t), cut);
  for (std::size_t i = 0; i < even.size(); ++i) even.y[i] -= high[i];
  return even;
}

}  // namespace seiche::apps
