#pragma once
#include "solver/operators/interactions.hpp"
#include "solver/operators/laplacian.hpp"
#include "solver/operators/strain_rate.hpp"
#include "solver/particles/each_fluid.hpp"

namespace seiche::solver {

/// The viscous force per mass on fluid particles, nu Laplacian(u) of equation (12) [m/s^2], in the form that the scene
/// names.
template <int D>
class Viscosity {
 public:
  explicit Viscosity(const Parameters& p)
      : model_(p.method.viscous), slip_(p.method.wall == WallSlip::free), nu_(p.fluid.viscosity) {}

  void operator()(const Range<D>& range, const State<D>& s, Vecs<D>& out) const {
    resize_kept(out, s.size());
    switch (model_) {
      case ViscousModel::strain_rate:
        strain_rate_divergence(*range.pairs, range.ref, slip_, s, out);
        break;
      case ViscousModel::laplacian:
        velocity_laplacian(*range.pairs, range.ref, slip_, s, out);
        break;
    }
    each_fluid(s, [&](int i) { out[i] *= nu_; });
  }

 private:
  ViscousModel model_;
  bool slip_;
  double nu_;  ///< kinematic [m^2/s]
};

}  // namespace seiche::solver
