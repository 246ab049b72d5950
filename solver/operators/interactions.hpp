#pragma once
#include <memory>

#include "solver/operators/kernels.hpp"
#include "solver/operators/reference.hpp"
#include "solver/parameters.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// A kernel with one support, its constants on the initial lattice, and the pairs within it.
template <int D>
struct Range {
  Kernel w;
  Reference ref;
  std::shared_ptr<Pairs<D>> pairs = std::make_shared<Pairs<D>>();  ///< ranges of one radius share them

  /// @param radius r_e [l0]
  Range(const Parameters& p, double radius)
      : w(find_kernel(p.method.kernel, radius * p.particles.spacing, p.method.kf2_alpha)),
        ref(std::visit([&](auto kernel) { return lattice_reference<D>(kernel, p.particles.spacing); }, w)) {}

  void measure(const Neighbours<D>& list, const State<D>& s) {
    std::visit([&](auto kernel) { pairs->measure(kernel, list, s); }, w);
  }
};

/// Who acts on whom: the neighbour list, and the pairs in range of each operator.
template <int D>
struct Interactions {
  Neighbours<D> list;
  Range<D> density;  ///< of the number density and the divergence
  Range<D> gradient, laplacian;

  /// @param low, high corners of all that particles fill at the start [m]
  /// @param longest support of all operators [l0]
  Interactions(const Parameters& p, const Vec<D>& low, const Vec<D>& high, double longest)
      // A skin of 0.3 l0 balances the cost of longer rows against that of making the list more often.
      : list(low, high, longest * p.particles.spacing, 0.3 * p.particles.spacing),
        density(p, p.method.radius_density),
        gradient(p, p.method.radius_gradient),
        laplacian(p, p.method.radius_laplacian) {
    if (p.method.radius_gradient == p.method.radius_density) gradient.pairs = density.pairs;
    if (p.method.radius_laplacian == p.method.radius_density) laplacian.pairs = density.pairs;
  }

  /// Measures all pairs at the present positions.
  void measure(const State<D>& s) {
    density.measure(list, s);
    if (gradient.pairs != density.pairs) gradient.measure(list, s);
    if (laplacian.pairs != density.pairs) laplacian.measure(list, s);
  }
};

}  // namespace seiche::solver
