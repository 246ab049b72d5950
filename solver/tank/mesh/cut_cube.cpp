#include "solver/tank/mesh/cut_cube.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {

double share_below(const Vec<3>& way, double at) {
  double m[3] = {std::abs(way[0]), std::abs(way[1]), std::abs(way[2])};
  std::sort(m, m + 3);
  const double all = m[0] + m[1] + m[2];
  if (all == 0) return at > 0;
  // From the corner that is first crossed, in units of the way to the last.
  const double share = at / all + 0.5;
  if (share <= 0) return 0;
  if (share >= 1) return 1;
  for (double& x : m) x /= all;
  if (m[0] < 1e-4) m[0] = 0;  // else the terms below cancel
  const double a = std::min(share, 1 - share), m1 = m[0], m2 = m[1], m3 = m[2], m12 = m1 + m2;
  double volume;
  if (a < m1) {
    volume = a * a * a / (6 * m1 * m2 * m3);
  } else if (a < m2) {
    volume = 0.5 * a * (a - m1) / (m2 * m3) + m1 * m1 / std::max(6 * m2 * m3, 1e-300);
  } else if (a < std::min(m12, m3) && m1 > 0) {
    volume = (a * a * (3 * m12 - a) + m1 * m1 * (m1 - 3 * a) + m2 * m2 * (m2 - 3 * a)) / (6 * m1 * m2 * m3);
  } else if (m3 < m12 && m1 > 0) {
    volume = (a * a * (3 - 2 * a) + m1 * m1 * (m1 - 3 * a) + m2 * m2 * (m2 - 3 * a) + m3 * m3 * (m3 - 3 * a)) /
             (6 * m1 * m2 * m3);
  } else {
    volume = 0.5 * (2 * a - m12) / m3;
  }
  return share < 0.5 ? volume : 1 - volume;
}

}  // namespace seiche::solver
