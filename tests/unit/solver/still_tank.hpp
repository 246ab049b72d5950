#pragma once
#include "solver/operators/density.hpp"
#include "solver/operators/kernels.hpp"
#include "solver/pressure/boundary.hpp"
#include "solver/pressure/pressure_system.hpp"
#include "solver/pressure/surface_pressure.hpp"
#include "solver/tank/filling.hpp"
#include "solver/tank/wall_wetness.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver::test {

/// 20 x 15 cells (x 12) filled to 10.
template <int D>
Parameters small_tank() {
  Parameters p;
  p.particles.spacing = l0;
  p.tank.length = 0.2;
  p.tank.height = 0.15;
  if (D == 3) p.tank.width = 0.12;
  p.fluid.depth = 0.1;
  return p;
}

/// The small tank at rest as a step finds it: pairs, densities, free surface. KF3, r_e = 2.6 l0.
template <int D>
struct StillTank {
  Parameters p;
  State<D> s = fill_tank<D>(p);
  KF3 w{2.6 * l0};
  Reference ref = lattice_reference<D>(w, l0);
  Neighbours<D> list = listed(s, w.support, 0.3 * l0);
  Scalars n = Scalars(s.size());
  Scalars count = Scalars(s.size());
  std::vector<std::uint8_t> near = std::vector<std::uint8_t>(s.size());
  Vec<D> slope = -p.fluid.density * p.gravity.size() * Vec<D>::Unit(1);
  mutable Vecs<D> slopes;

  explicit StillTank(const Parameters& parameters = small_tank<D>());

  Pairs<D> pairs() const { return measured(w, list, s); }

  void find_surface();

  /// Walls are wet at first, dry ones too.
  void wet_walls();

  void set_surface_pressure();

  /// rho g (depth - y).
  double hydrostatic(const Vec<D>& r) const { return slope.norm() * (p.fluid.depth - r[1]); }

  PaperBoundary<D> paper() const { return {s}; }
  /// The slope at each particle.
  const Vecs<D>& everywhere() const {
    slopes.assign(s.size(), slope);
    return slopes;
  }
  GhostBoundary<D> ghost() const { return {s, n, near, ref.n0, ref.n0, everywhere()}; }
  template <class Boundary>
  PressureSystem<D> system(const Boundary& boundary, double diagonal = 0) const {
    PressureSystem<D> system;
    system.assemble(pairs(), diagonal, boundary, s);
    return system;
  }
};

}  // namespace seiche::solver::test
