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
      const std::span<const int> row = list[i];
      int out = row_[i].first = list.offset(i);
      // In blocks, first all that several pairs can share one instruction for, then what each does alone.
      constexpr int block = 64;
      double squared[block], weight[block];
      for (int begin = 0; begin < static_cast<int>(row.size()); begin += block) {
        const int* js = row.data() + begin;
        const int count = std::min<int>(block, row.size() - begin);
#pragma omp simd
        for (int m = 0; m < count; ++m) {
          const double r2 = squared_distance<D>(s.position, js[m], ri);
          squared[m] = r2;
          weight[m] = w(std::sqrt(r2)) / r2;
        }
        // Written whether it counts or not: a third of the pairs don't, at random, which no branch would foresee.
        for (int m = 0; m < count; ++m) {
          index_[out] = js[m];
          weight_[out] = weight[m];
          out += squared[m] < reach;
        }
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
