#pragma once
#include <array>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// sum a b^T. Kept by rows: to fill a wide register with a whole matrix takes longer than it saves.
template <int D>
class OuterSum {
 public:
  OuterSum() { row_.fill(Vec<D>::Zero()); }

  void add(const Vec<D>& a, const Vec<D>& b) {
    for (int k = 0; k < D; ++k) row_[k] += a[k] * b;
  }

  Eigen::Matrix<double, D, D> matrix() const {
    Eigen::Matrix<double, D, D> m;
    for (int k = 0; k < D; ++k) m.row(k) = row_[k];
    return m;
  }

 private:
  std::array<Vec<D>, D> row_;
};

}  // namespace seiche::solver
