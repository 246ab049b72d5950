#pragma once
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver::test {

/// The pressure equation of a tank of cells[0] x cells[1] (x cells[2]) fluid particles at rest that have been moved by
/// up to `stir` spacings on each axis, with a source that isn't smooth on the right-hand side.
template <int D>
struct StirredSystem {
  PressureSystem<D> system;
  Eigen::VectorXd b;

  /// @param full the liquid fills the tank: no free surface, only `diagonal` n0 makes the matrix regular
  explicit StirredSystem(const Eigen::Matrix<int, D, 1>& cells, double stir = 0.15, bool full = false,
                         double diagonal = 1e-7) {
    Parameters p;
    p.particles.spacing = l0;
    p.tank.length = cells[0] * l0;
    p.tank.height = (cells[1] + (full ? 0 : 5)) * l0;
    if (D == 3) p.tank.width = cells[D - 1] * l0;
    p.fluid.depth = cells[1] * l0;
    StillTank<D> tank(p);
    std::mt19937_64 random(11);
    for (std::size_t i = 0; i < tank.s.size(); ++i)
      if (tank.s.kind[i] == Kind::fluid) tank.s.position[i] += stir * l0 * random_vec<D>(random, -1, 1);
    tank.list = listed(tank.s, tank.w.support, 0.3 * l0);
    tank.find_surface();
    if (full) {
      std::fill(tank.s.surface.begin(), tank.s.surface.end(), 0);
      std::fill(tank.near.begin(), tank.near.end(), 0);
    }
    tank.set_surface_pressure();
    system = tank.system(tank.ghost(), diagonal * tank.ref.n0);
    b = system.rhs();
    for (int k = 0; k < b.size(); ++k) b[k] += 10 * std::sin(k);
  }

  SparseView matrix() const { return system.matrix(); }
  int rows() const { return system.rows(); }
};

}  // namespace seiche::solver::test
