#pragma once
#include "apps/common/series.hpp"

namespace seiche::apps::validate {

/// What two series are compared over.
struct Window {
  double from, to;     ///< [s]; what both series have of it is used
  double zero = 0;     ///< rest value of the quantity
  double period = 1;   ///< of the oscillation [s], for what counts as a gap
  double step = 0.01;  ///< between two comparisons [s]
};

/// How a series differs from a reference, with e = series - reference at the times of the window.
struct Difference {
  std::size_t count = 0;
  double rms = 0;        ///< of e
  double bias = 0;       ///< mean of e
  double most = 0;       ///< max |e|
  double ref_most = 0;   ///< max |reference - zero|
  double ref_rms = 0;    ///< of reference - zero
  double deviation = 0;  ///< standard deviation of the reference

  double of_most() const { return rms / ref_most; }        ///< 0 is perfect
  double relative_l2() const { return rms / ref_rms; }     ///< 0 is perfect, 1 as bad as rest
  double of_deviation() const { return rms / deviation; }  ///< 0 is perfect, 1 as bad as a constant mean
  double unbiased_of_most() const;                         ///< of_most() of e less its mean
};

/// Both series are taken linear between samples. Times in a gap of either are left out: an interval longer than
/// max(0.3 periods, 5 median intervals). Throws std::runtime_error where fewer than four times are left.
Difference compare(const Series& reference, const Series& series, const Window& window);

}  // namespace seiche::apps::validate
