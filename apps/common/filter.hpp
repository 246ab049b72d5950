#pragma once
#include <vector>

#include "apps/common/series.hpp"

namespace seiche::apps {

/// What lies above `cut`: a Butterworth filter of second order run forwards and backwards, so that it is of fourth
/// order and shifts no phase. Its gain is 1/(1 + (tan(pi cut/rate)/tan(pi f/rate))^4): a half at the cut. The ends are
/// reflected about their points over 3 rate/cut samples.
/// @param y samples at equal intervals
/// @param rate [Hz]
/// @param cut [Hz]
std::vector<double> high_pass(const std::vector<double>& y, double rate, double cut);

/// The series of [from, to] at equal intervals, its own median one but 0.5 ms at least.
/// Throws std::runtime_error for fewer than 50 samples, or fewer than 4 a period of `cut`.
Series resampled(const Series& series, double from, double to, double cut);

/// Root mean square of what lies above `cut` in [from, to]. Throws as resampled().
double noise(const Series& series, double from, double to, double cut);

/// What lies below `cut` in [from, to]. Throws as resampled().
Series low_pass(const Series& series, double from, double to, double cut);

}  // namespace seiche::apps
