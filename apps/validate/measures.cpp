#include "apps/validate/measures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace seiche::apps::validate {
namespace {

double longest_step(const Series& series, double period) {
  return std::max(0.3 * period, 5 * median_interval(series.t));
}

bool in_gap(const Series& series, double time, double longest) {
  const std::size_t i = std::upper_bound(series.t.begin(), series.t.end(), time) - series.t.begin();
  return i == 0 || series.t[std::min(i, series.size() - 1)] - series.t[i - 1] > longest;
}

}  // namespace

double Difference::unbiased_of_most() const { return std::sqrt(std::max(0.0, rms * rms - bias * bias)) / ref_most; }

Difference compare(const Series& reference, const Series& series, const Window& window) {
  if (reference.t.empty() || series.t.empty()) throw std::runtime_error("nothing to compare");
  const double from = std::max({reference.t.front(), series.t.front(), window.from});
  const double to = std::min({reference.t.back(), series.t.back(), window.to});
  const long steps = static_cast<long>(std::floor((to - from) / window.step + 1e-6));
  const double gap = longest_step(reference, window.period), own_gap = longest_step(series, window.period);
  std::vector<double> error, level;
  for (long i = 0; i <= steps; ++i) {
    const double t = from + static_cast<double>(i) * window.step;
    if (in_gap(reference, t, gap) || in_gap(series, t, own_gap)) continue;
    level.push_back(reference.at(t) - window.zero);
    error.push_back(series.at(t) - reference.at(t));
  }
  if (error.size() < 4)
    throw std::runtime_error(
        fmt::format("a run and its reference share no time in {:g}-{:g} s", window.from, window.to));

  const double n = static_cast<double>(error.size());
  Difference d;
  d.count = error.size();
  d.rms = rms(error);
  d.ref_rms = rms(level);
  double mean = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    d.bias += error[i] / n;
    mean += level[i] / n;
    d.most = std::max(d.most, std::abs(error[i]));
    d.ref_most = std::max(d.ref_most, std::abs(level[i]));
  }
  d.deviation = std::sqrt(std::max(0.0, d.ref_rms * d.ref_rms - mean * mean));
  return d;
}

}  // namespace seiche::apps::validate
