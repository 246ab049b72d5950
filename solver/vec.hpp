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

}  // namespace seiche::solver
