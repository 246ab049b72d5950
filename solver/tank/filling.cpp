#include "solver/tank/filling.hpp"

#include "solver/tank/pools.hpp"

namespace seiche::solver {
namespace {

/// A place no nearer to the wall than that [m]: the centroid of a sliver of liquid lies at the wall, or, where the wall
/// is curved, may lie just behind it.
template <int D>
Vec<D> off_the_wall(const Shape<D>& tank, const Vec<D>& r, double distance) {
  const Nearest<D> wall = tank.nearest(r);
  return wall.distance > -distance ? Vec<D>(r - (wall.distance + distance) * wall.normal) : r;
}

/// A place no nearer to any side of a baffle than that, on the same side [m].
template <int D>
Vec<D> off_baffles(const Baffles<D>& baffles, Vec<D> r, double distance) {
  for (const BaffleFace<D>& face : baffles.faces()) {
    const double before = -face.behind(r);
    if (before >= 0 && before < distance && (face.nearest(r) - r).norm() < distance)
      r -= (distance - before) * face.normal_at(r);
  }
  return r;
}

/// Adds a pool: a particle for each cell of its lattice, in cells that a wall cuts as many as their liquid fills, each
/// at the centroid of that, l0/10 off the wall or more. N l0^D is the liquid's volume within half a particle. The
/// pressure is hydrostatic.
template <int D>
void add_liquid(const Parameters& p, const Shape<D>& tank, const Pool<D>& pool, const Gravity& gravity, State<D>& s) {
  const double l0 = p.particles.spacing;
  CutCells<D> cut(s.baffles.get());
  long whole = 0;
  for (const auto& [cell, number, inside] : pool.parts)
    if (inside.share == 1)
      ++whole;
    else
      cut.add(cell, number, inside.share, inside.centroid);
  // Liquid that begins as a column stands in a box, which cuts no cell.
  if (whole < static_cast<long>(pool.parts.size())) cut.choose(std::lround(pool.volume / std::pow(l0, D)) - whole);
  for (const auto& [cell, number, inside] : pool.parts) {
    if (inside.share < 1 && !cut.has_particle(cell, number)) continue;
    Vec<D> r = inside.share < 1 ? off_the_wall(tank, inside.centroid, 0.1 * l0) : inside.centroid;
    if (s.baffles) r = off_baffles(*s.baffles, r, 0.1 * l0);
    s.add(r, Kind::fluid, Vec<D>::Zero());
    s.pressure.back() = still_pressure(p.fluid.density, gravity, pool.level, pool.lattice.axes.height(r));
  }
}

/// Adds the wall particles and dummies.
template <int D>
void add_walls(const Parameters& p, const Shape<D>& tank, State<D>& s) {
  const double l0 = p.particles.spacing;
  const auto points = tank.wall_points(wall_layers(p.method), l0, longest_support(p.method) * l0);
  for (const Kind kind : {Kind::wall, Kind::dummy})
    for (const WallPoint<D>& point : points) {
      if ((point.layer == 0) != (kind == Kind::wall)) continue;
      s.add(point.position, kind, point.normal, point.weight);
      s.behind.back() = point.behind;
      if (point.faces.empty()) continue;
      s.edge.back() = static_cast<int>(s.edges.size());
      s.edges.push_back(point.faces);
    }
}

}  // namespace

template <int D>
State<D> fill_tank(const Parameters& p, const Shape<D>& tank, const RelativeEquilibrium& at_rest) {
  State<D> s;
  s.baffles = tank.baffles();
  for (const Pool<D>& pool : pools_of(p, tank, at_rest)) add_liquid(p, tank, pool, at_rest.gravity, s);
  add_walls(p, tank, s);
  return s;
}

template State<2> fill_tank(const Parameters&, const Shape<2>&, const RelativeEquilibrium&);
template State<3> fill_tank(const Parameters&, const Shape<3>&, const RelativeEquilibrium&);

}  // namespace seiche::solver
