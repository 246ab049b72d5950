#pragma once
#include <Eigen/SparseCore>

namespace seiche::solver {

using SparseMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, int>;
using SparseView = Eigen::Map<const SparseMatrix>;
using VectorView = Eigen::Map<Eigen::VectorXd>;

}  // namespace seiche::solver
