#include "solver/tank/check_whole.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/errors.hpp"

namespace seiche::solver {

bool is_whole(double length, double l0) {
  const double cells = length / l0;
  return std::abs(cells - std::round(cells)) <= 1e-6 * cells;
}

void check_whole(const char* key, double length, double l0) {
  const double cells = length / l0;
  const double below = std::floor(cells) * l0, above = std::ceil(cells) * l0;
  if (!is_whole(length, l0))
    throw BadParameters(fmt::format(
        "{} = {:.6g} m is {:.3f} spacings of {:.6g} m; it must be a whole number of them, as {:.6g} or {:.6g} m are",
        key, length, cells, l0, below, above));
  if (std::lround(cells) < 4)
    throw BadParameters(fmt::format(
        "{} = {:.6g} m is {} spacings of {:.6g} m; a run needs 4 at least: take a smaller particles.spacing", key,
        length, std::lround(cells), l0));
}

}  // namespace seiche::solver
