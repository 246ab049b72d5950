#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver::test {

template <int D>
StillTank<D>::StillTank(const Parameters& parameters) : p(parameters) {
  find_surface();
}

template <int D>
void StillTank<D>::find_surface() {
  number_density(pairs(), s, n, count);
  mark_free_surface(ref, 0.97, 0.85, n, count, s.kind, s.surface);
  mark_near_surface(pairs(), s, near);
}

template <int D>
void StillTank<D>::wet_walls() {
  WallWetness<D> wetness(w, l0);
  wetness.relist(list, s);
  wetness(pairs(), ref.n0, Vec<D>::Unit(1), s);
  find_surface();
}

template <int D>
void StillTank<D>::set_surface_pressure() {
  const Vecs<D> inviscid(s.size(), Vec<D>::Zero());
  solver::set_surface_pressure(1, everywhere(), inviscid, surface_depth<D>(w, l0), n, s);
}

template struct StillTank<2>;
template struct StillTank<3>;

}  // namespace seiche::solver::test
