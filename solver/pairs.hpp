#pragma once
#include "solver/neighbours.hpp"

namespace seiche::solver {

/// The pairs within a kernel's support and their weights: measured once for the positions of a step and shared by all
/// operators of that radius, which then evaluate no kernel and no square root and meet no pair that doesn't count.
template <int D>
class Pairs {
 public:
  /// Measures the listed pairs. Rows keep the list's order, j rising; dummies have none.
  template <class K>
  void measure(const K& w, const Neighbours<D>& list, const State<D>& s) {
    const int size = static_cast<int>(s.size());
    row_.resize(size);
    index_.resize(list.capacity());
    weight_.resize(list.capacity());
    const double reach = w.support * w.support;
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i) {
      const Vec<D> ri = s.position[i];
      int out = row_[i].first = list.offset(i);
      for (int j : list[i]) {
        const double r2 = (s.position[j] - ri).squaredNorm();
        // Written whether it counts or not: a third of the pairs don't, at random, which no branch would foresee.
        index_[out] = j;
        weight_[out] = w(std::sqrt(r2)) / r2;
        out += r2 < reach;
      }
      row_[i].last = out;
    }
  }

  /// Calls f(j, r_ij, w(r_ij)/r_ij^2) for each pair of i.
  template <class F>
  void each(int i, const State<D>& s, F f) const {
    const Vec<D> ri = s.position[i];
    for (int k = row_[i].first; k < row_[i].last; ++k) f(index_[k], Vec<D>(s.position[index_[k]] - ri), weight_[k]);
  }

  /// The j of all pairs of i.
  std::span<const int> operator[](int i) const { return {index_.data() + row_[i].first, index_.data() + row_[i].last}; }

 private:
  struct Row {
    int first, last;
  };
  std::vector<Row> row_;
  std::vector<int> index_;
  Scalars weight_;
};

}  // namespace seiche::solver
