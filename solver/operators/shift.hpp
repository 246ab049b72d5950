#pragma once
#include "solver/operators/interactions.hpp"

namespace seiche::solver {

/// Particle shifting: the displacement -share l0^2 (d/n0) sum_j r_ij w/r_ij^2 of each fluid particle away from the free
/// surface (`near` 0), towards where neighbours are sparse (after Xu, Stansby, Laurence 2009) [m]; zero elsewhere,
/// and within l0 of a plate's rim, where liquid that comes out of its shadow would make it jump.
/// @param share strength sqrt(g H) dt/l0: particles even out at a rate of their own, whatever the step
template <int D>
void particle_shift(const Pairs<D>& pairs, double n0, double share, double l0, const std::vector<std::uint8_t>& near,
                    const State<D>& s, Vecs<D>& out) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i].setZero();
    if (s.kind[i] != Kind::fluid || near[i] || share == 0) continue;
    if (s.baffles && s.baffles->is_at_rim(s.position[i], l0)) continue;
    Vec<D> sum = Vec<D>::Zero();
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) { sum -= s.volume[j] * weight * rij; });
    out[i] = share * l0 * l0 * D / n0 * sum;
  }
}

/// Particle shifting at the rate that the scene names.
class ParticleShift {
 public:
  /// @param wave_speed sqrt(g H) [m/s]
  ParticleShift(const Parameters& p, double wave_speed)
      : strength_(p.method.shift), wave_speed_(wave_speed), l0_(p.particles.spacing) {}

  /// Displacements in a step of length dt [m].
  template <int D>
  void operator()(const Range<D>& range, double dt, const State<D>& s, Vecs<D>& out) const {
    resize_kept(out, s.size());
    const double share = strength_ * dt * wave_speed_ / l0_;
    particle_shift(*range.pairs, range.ref.n0, share, l0_, s.near_surface, s, out);
  }

 private:
  double strength_, wave_speed_, l0_;  ///< [-], sqrt(g H) [m/s], [m]
};

}  // namespace seiche::solver
