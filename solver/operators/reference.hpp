#pragma once
#include <cmath>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Constants of a kernel on the initial lattice.
struct Reference {
  double n0 = 0;      ///< particle number density, equation (3)
  double lambda = 0;  ///< sum w r^2 / sum w, equation (6) with the sum that the paper's denominator lacks [m^2]
  int count = 0;      ///< neighbours within the support
};

/// n0 and lambda at a particle of the lattice of spacing l0 in D dimensions, all neighbours present.
template <int D, class K>
Reference lattice_reference(const K& w, double l0) {
  Reference ref;
  const int m = static_cast<int>(std::ceil(w.support / l0));
  for (int k = D > 2 ? -m : 0; k <= (D > 2 ? m : 0); ++k)
    for (int j = D > 1 ? -m : 0; j <= (D > 1 ? m : 0); ++j)
      for (int i = -m; i <= m; ++i) {
        const double r = l0 * std::sqrt(double(i) * i + double(j) * j + double(k) * k);
        if (r == 0 || r >= w.support) continue;
        ref.n0 += w(r);
        ref.lambda += w(r) * r * r;
        ++ref.count;
      }
  ref.lambda /= ref.n0;
  return ref;
}

}  // namespace seiche::solver
