#pragma once
#include "solver/sensors/sensor.hpp"
#include "solver/tank/filling.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver::test {

/// The small tank at rest, with the cells that its sensors read.
template <int D>
struct SensedTank {
  Parameters p;
  std::shared_ptr<const Shape<D>> shape = make_shape<D>(p);
  State<D> s = fill_tank<D>(p, *shape);
  double weight = p.fluid.density * p.gravity.size();  ///< rho g [Pa/m]

  explicit SensedTank(const Parameters& parameters = small_tank<D>()) : p(parameters) {}

  FluidCells<D> cells() const {
    FluidCells<D> cells(shape->bounds(), p.particles.spacing);
    cells.sort(s);
    return cells;
  }

  SensorSite<D> site() const { return {p, *shape, s}; }

  SurfaceProfile<D> profile() const { return {*shape, p.gravity, p.particles.spacing, s}; }

  /// A point in 2-D; in 3-D midway across.
  static Vec<D> at(double x, double y) {
    Vec<D> r = Vec<D>::Constant(0.06);
    r[0] = x;
    r[1] = y;
    return r;
  }

  /// Calls f(r, p) for every fluid particle, to move it and give it a pressure.
  template <class F>
  void each_fluid(F f) {
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.kind[i] == Kind::fluid) f(s.position[i], s.pressure[i]);
  }
};

}  // namespace seiche::solver::test
