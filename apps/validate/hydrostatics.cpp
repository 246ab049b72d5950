#include "apps/validate/hydrostatics.hpp"

#include <algorithm>
#include <cmath>

#include "apps/common/series.hpp"

namespace seiche::apps::validate {

double hydrostatic_error(const Frame& frame, const RunInfo& run) {
  const double weight = run.density * run.gravity, level = run.tank.low()[1] + run.depth;
  std::vector<double> errors;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) errors.push_back(frame.pressure[i] - weight * (level - frame.position[i][1]));
  return rms(errors) / (weight * run.depth);
}

double greatest_speed(const Frame& frame) {
  double most = 0;
  for (const Float3& v : frame.velocity) most = std::max<double>(most, std::hypot(v[0], v[1], v[2]));
  return most;
}

}  // namespace seiche::apps::validate
