#include "solver/tank/shapes/bend.hpp"

#include <algorithm>
#include <cmath>

#include "solver/tank/shapes/path.hpp"

namespace seiche::solver {

Bends::Bends(const Contour& wall) {
  for (const auto& loop : wall.loops())
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Edge &before = loop[k], &after = loop[(k + 1) % loop.size()];
      const double turn = turn_between(before, after);
      if (std::abs(turn) < 0.087) continue;
      const Vec<2> a = before.normal(1), b = after.normal(0);
      bends_.push_back({after.from, turn, {a, a.dot(after.from)}, {b, b.dot(after.from)}});
    }
}

Behind Bends::behind(const Contour& wall, const Vec<2>& r, double reach) const {
  const Nearest<2> near = wall.nearest(r);
  Behind result{near.normal, near.patch, {}};
  const double small = 1e-9 * reach;
  if ((r - near.foot - near.distance * near.normal).norm() > small) {
    const bool beyond = std::any_of(bends_.begin(), bends_.end(), [&](const Bend& bend) {
      return bend.turn >= 0.5 && (bend.at - near.foot).norm() < small;
    });
    result.normal = beyond ? Vec<2>(Vec<2>::Zero()) : Vec<2>((r - near.foot) / near.distance);
  }
  const auto add = [&](const Face<2>& face) {
    for (const Face<2>& other : result.faces)
      if ((face.normal - other.normal).norm() < 1e-9 && std::abs(face.offset - other.offset) < small) return;
    result.faces.push_back(face);
  };
  for (const Bend& bend : bends_) {
    if (bend.turn > 0 || (bend.at - r).norm() > reach) continue;
    add(bend.before);
    add(bend.after);
  }
  return result;
}

}  // namespace seiche::solver
