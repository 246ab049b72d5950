#include "render/curves/running_mean.hpp"

#include <cmath>
#include <limits>

#include "render/picture/polyline.hpp"

namespace seiche::render {

Series running_mean(const Series& series, double window) {
  Series mean{series.time, {}};
  const double reach = window / 2 * (1 + time_slack);
  std::vector<double> sums{0};  // of the finite values before each
  std::vector<long> counts{0};
  for (const double value : series.value) {
    const bool finite = std::isfinite(value);
    sums.push_back(sums.back() + (finite ? value : 0));
    counts.push_back(counts.back() + finite);
  }
  std::size_t first = 0, after = 0;
  for (const double time : series.time) {
    while (series.time[first] < time - reach) ++first;
    while (after < series.time.size() && series.time[after] <= time + reach) ++after;
    const long count = counts[after] - counts[first];
    mean.value.push_back(count > 0 ? (sums[after] - sums[first]) / static_cast<double>(count)
                                   : std::numeric_limits<double>::quiet_NaN());
  }
  return mean;
}

}  // namespace seiche::render
