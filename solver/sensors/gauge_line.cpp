#include "solver/sensors/gauge_line.hpp"

#include <cmath>

namespace seiche::solver {
namespace {

/// How far a line goes from a point before it leaves the tank or meets a baffle [m].
template <int D>
double way_inside(const Shape<D>& tank, const Vec<D>& from, const Vec<D>& direction, double l0) {
  const auto baffles = tank.baffles();
  const double most = 2 * tank.bounds().size().norm(), tolerance = 1e-6 * l0;
  const auto is_inside = [&](double at) {
    const Vec<D> r = from + at * direction;
    return tank.nearest(r).distance <= tolerance && (!baffles || baffles->sees(from, r));
  };
  double inside = 0, outside = 0;
  while (outside == 0 && inside < most) (is_inside(inside + 0.25 * l0) ? inside : outside) = inside + 0.25 * l0;
  while (outside - inside > tolerance) {
    const double middle = 0.5 * (inside + outside);
    (is_inside(middle) ? inside : outside) = middle;
  }
  return inside;
}

}  // namespace

template <int D>
GaugeLine<D> line_of(const Parameters::WaveGauge& gauge, const Shape<D>& tank, const std::vector<Pool<D>>& pools) {
  const LevelAxes<D>& axes = pools.front().lattice.axes;
  const Eigen::Vector3d given(gauge.direction.data());
  const bool is_up = given.isZero();
  GaugeLine<D> line;
  line.point = Vec<3>(gauge.x, gauge.y, gauge.z).template head<D>();
  line.direction = is_up ? axes.up() : Vec<D>(given.normalized().template head<D>());
  line.crossing = gauge.crossing;
  const double level = level_beside(pools, line.point), rise = line.direction.dot(axes.up());
  if (is_up) line.point += (level - axes.height(line.point)) * axes.up();
  if (std::abs(rise) > 1e-6) line.still = (level - axes.height(line.point)) / rise;
  const double l0 = pools.front().lattice.l0;
  line.low = -way_inside<D>(tank, line.point, -line.direction, l0);
  line.high = way_inside<D>(tank, line.point, line.direction, l0);
  return line;
}

template <int D>
double crossing_of(const GaugeLine<D>& line, const SurfaceProfile<D>& surface) {
  const double step = 0.25 * surface.lattice().l0, way = line.high - line.low;
  const bool highest = line.crossing == Crossing::highest;
  const auto place = [&](double gone) { return highest ? line.high - gone : line.low + gone; };
  const auto fraction = [&](double gone) { return surface.fraction(line.at(place(gone))); };
  const auto is_beyond = [&](double found) { return highest ? found >= 0.5 : found < 0.5; };
  double gone = 0, before = fraction(0);
  if (is_beyond(before)) return place(0);
  while (gone < way) {
    const double next = std::min(gone + step, way), here = fraction(next);
    if (is_beyond(here)) return place(gone + (next - gone) * (0.5 - before) / (here - before));
    gone = next;
    before = here;
  }
  return highest ? line.low : line.high;
}

template GaugeLine<2> line_of(const Parameters::WaveGauge&, const Shape<2>&, const std::vector<Pool<2>>&);
template double crossing_of(const GaugeLine<2>&, const SurfaceProfile<2>&);
template GaugeLine<3> line_of(const Parameters::WaveGauge&, const Shape<3>&, const std::vector<Pool<3>>&);
template double crossing_of(const GaugeLine<3>&, const SurfaceProfile<3>&);

}  // namespace seiche::solver
