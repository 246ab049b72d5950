#pragma once
#include "solver/operators/density.hpp"
#include "solver/operators/interactions.hpp"

namespace seiche::solver {

/// Number density (3) and free surface (11), by the test that the scene names.
template <int D>
class SurfaceDetection {
 public:
  explicit SurfaceDetection(const Parameters::Method& m)
      : beta_(m.surface_beta), share_(m.surface == SurfaceTest::density ? 0 : count_share) {}

  /// Sets the state's density, surface and near_surface.
  void operator()(const Range<D>& range, State<D>& s) {
    resize_kept(count_, s.size());
    number_density(*range.pairs, s, s.density, count_);
    mark_free_surface(range.ref, beta_, share_, s.density, count_, s.kind, s.surface);
    mark_near_surface(*range.pairs, s, s.near_surface);
  }

 private:
  double beta_, share_;
  Scalars count_;
};

}  // namespace seiche::solver
