#pragma once
#include <Eigen/Core>
#include <vector>

namespace seiche::solver {

/// A point or vector in D dimensions: x along the tank, y up, z across.
template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

template <int D>
using Vecs = std::vector<Vec<D>>;

using Scalars = std::vector<double>;

/// |r_j - r|^2. By components, which g++ turns into vector instructions over j where it doesn't with Eigen's.
template <int D>
double squared_distance(const Vecs<D>& at, int j, const Vec<D>& r) {
  const double* rj = at.data()->data() + D * j;
  double sum = 0;
  for (int a = 0; a < D; ++a) sum += (rj[a] - r[a]) * (rj[a] - r[a]);
  return sum;
}

}  // namespace seiche::solver
