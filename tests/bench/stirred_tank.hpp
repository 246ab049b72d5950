#pragma once
#include <cmath>

#include "solver/operators/close_pairs.hpp"
#include "solver/operators/divergence.hpp"
#include "solver/operators/volume.hpp"
#include "solver/pressure/source.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::bench {

using solver::test::l0;

/// A tank twice as high as its liquid and three times as long, with 3 m^2 particles of fluid, as near to `particles` as
/// whole m come.
inline Parameters tank_of(int particles) {
  const double m = std::round(std::sqrt(particles / 3.0));
  Parameters p;
  p.particles.spacing = l0;
  p.tank.length = 3 * m * l0;
  p.tank.height = 2 * m * l0;
  p.fluid.depth = m * l0;
  return p;
}

/// Such a tank of still liquid, its particles moved by up to 0.15 l0 and with small velocities: as a stage of a step
/// finds it. KF3, r_e = 2.6 l0.
struct StirredTank : solver::test::StillTank<2> {
  static constexpr int D = 2;
  std::shared_ptr<const solver::Shape<D>> tank = solver::make_shape<D>(p);
  solver::WallWetness<D> wetness{w, l0};
  solver::VolumeKernel volume{l0};
  double whole = 1 + solver::lattice_reference<D>(volume, l0).n0;
  solver::Vecs<D> slopes;
  solver::Pairs<D> near_pairs;
  solver::PressureSystem<D> pressure;
  solver::Scalars divergence, excess;
  solver::VelocityGradients<2> gradient;
  solver::Vecs<D> vectors;
  solver::Collisions<D> collisions;
  int fluid = 0;

  explicit StirredTank(int particles) : StillTank<D>(tank_of(particles)) {
    std::mt19937_64 random(11);
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (s.kind[i] != Kind::fluid) continue;
      ++fluid;
      s.position[i] += solver::test::random_vec<D>(random, -0.15 * l0, 0.15 * l0);
      s.velocity[i] = solver::test::random_vec<D>(random, -0.1, 0.1);
      s.pressure[i] = hydrostatic(s.position[i]);
    }
    list = solver::test::listed(s, w.support, 0.3 * l0);
    wet_walls();
    set_surface_pressure();
    wetness.relist(list, s);
    near_pairs.measure(w, list, s);
    slopes = everywhere();
    divergence = excess = solver::Scalars(s.size());
    gradient.resize(s.size());
    vectors.resize(s.size());
    assemble();
  }

  void assemble() {
    const solver::GhostBoundary<D> boundary{s, n, near, ref.n0, ref.n0, slopes};
    pressure.assemble(near_pairs, solver::definite * ref.n0, boundary, s);
  }
};

/// One of this size, made when it is first asked for.
StirredTank& stirred_tank(int particles);

}  // namespace seiche::bench
