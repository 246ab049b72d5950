#include "solver/tank/cell_part.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::solver {
namespace {

/// Calls f(centre, share) for each of parts^D equal parts of a cell that lies inside the tank, by a share of the cell.
/// @param axes along which the cell's sides lie
template <int D, class F>
void each_small_part(const Shape<D>& tank, const Vec<D>& centre, double side, const LevelAxes<D>& axes, int parts,
                     F f) {
  const int all = D == 2 ? parts * parts : parts * parts * parts;
  const double part = side / parts;
  const Vec<D> middle = axes(centre);
  for (int k = 0; k < all; ++k) {
    Vec<D> offset;
    for (int a = 0, rest = k; a < D; ++a, rest /= parts) offset[a] = (rest % parts + 0.5) * part - 0.5 * side;
    const Vec<D> at = axes.in_tank(middle + offset);
    const double share = std::clamp(0.5 - tank.nearest(at).distance / part, 0.0, 1.0);
    if (share > 0) f(at, share / all);
  }
}

}  // namespace

template <int D>
CellPart<D> part_inside(const Shape<D>& tank, const Vec<D>& centre, double side, const LevelAxes<D>& axes) {
  const double beyond = tank.nearest(centre).distance, half_diagonal = axes.half_diagonal(axes(centre), side);
  if (beyond <= -half_diagonal) return {1, centre};
  if (beyond >= half_diagonal) return {0, centre};
  double sum = 0;
  Vec<D> moment = Vec<D>::Zero();
  each_small_part(tank, centre, side, axes, D == 2 ? 8 : 6, [&](const Vec<D>& r, double share) {
    sum += share;
    moment += share * (r - centre);
  });
  if (sum < 1e-6) return {0, centre};
  if (sum > 1 - 1e-6) return {1, centre};
  return {sum, centre + moment / sum};
}

template <int D>
std::vector<CellPart<D>> parts_inside(const Shape<D>& tank, const Baffles<D>* baffles, const Vec<D>& centre,
                                      double side, const LevelAxes<D>& axes) {
  const CellPart<D> whole = part_inside(tank, centre, side, axes);
  if (!baffles || whole.share == 0 || !baffles->is_near(centre, axes.half_diagonal(axes(centre), side))) return {whole};
  std::vector<CellPart<D>> parts;
  Vecs<D> seen_from;
  each_small_part(tank, centre, side, axes, D == 2 ? 40 : 6, [&](const Vec<D>& r, double share) {
    std::size_t k = 0;
    while (k < parts.size() && !baffles->sees(seen_from[k], r)) ++k;
    if (k == parts.size()) parts.push_back({0, Vec<D>::Zero()}), seen_from.push_back(r);
    parts[k].share += share;
    parts[k].centroid += share * r;
  });
  if (parts.size() == 1) return {whole};
  for (CellPart<D>& part : parts) part.centroid /= part.share;
  return parts;
}

template CellPart<2> part_inside(const Shape<2>&, const Vec<2>&, double, const LevelAxes<2>&);
template CellPart<3> part_inside(const Shape<3>&, const Vec<3>&, double, const LevelAxes<3>&);
template std::vector<CellPart<2>> parts_inside(const Shape<2>&, const Baffles<2>*, const Vec<2>&, double,
                                               const LevelAxes<2>&);
template std::vector<CellPart<3>> parts_inside(const Shape<3>&, const Baffles<3>*, const Vec<3>&, double,
                                               const LevelAxes<3>&);

}  // namespace seiche::solver
