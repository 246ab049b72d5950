#pragma once
#include <vector>

#include "apps/common/series.hpp"

namespace seiche::apps::validate {

/// Order of convergence: the slope of the least-squares line through (ln spacing, ln error).
double order(const std::vector<double>& spacings, const std::vector<double>& errors);

/// y = amplitude exp(-decay t) cos(omega t + phase).
struct Oscillation {
  double amplitude = 0, decay = 0, omega = 0, phase = 0;

  double at(double t) const;
};

/// The damped oscillation that fits the series best: least squares by Gauss-Newton from `omega` and no decay, the
/// phase's two components being linear. All of the series is used, so that what scatters from sample to sample averages
/// out, which zero crossings and crests don't do. Throws std::runtime_error where it does not converge.
Oscillation fit_oscillation(const Series& series, double omega);

}  // namespace seiche::apps::validate
