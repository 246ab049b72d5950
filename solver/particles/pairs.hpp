#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "solver/particles/kept.hpp"
#include "solver/particles/neighbours.hpp"

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
    resize_kept(row_, size);
    resize_kept(chunk_, chunks_of(size));
    each_chunk<2>(size, [&](int first, int last) {
      Chunk& chunk = chunk_[first / chunk_rows];
      resize_kept(chunk.index, list.entries(first / chunk_rows));
      resize_kept(chunk.weight, list.entries(first / chunk_rows));
      int count = 0;
      chunk.least_squared = std::numeric_limits<double>::infinity();
      for (int i = first; i < last; ++i) {
        row_[i].first = count;
        row_[i].last = count = add_row(w, list[i], s, i, chunk, count);
      }
    });
  }

  /// The least distance of two particles when last measured [m]; infinite if no two were listed.
  double least_distance() const {
    double least = std::numeric_limits<double>::infinity();
    for (const Chunk& chunk : chunk_) least = std::min(least, chunk.least_squared);
    return std::sqrt(least);
  }

  /// Calls f(j, r_ij, w(r_ij)/r_ij^2) for each pair of i.
  template <class F>
  void each(int i, const State<D>& s, F f) const {
    const Vec<D> ri = s.position[i];
    const Chunk& chunk = chunk_[i / chunk_rows];
    const int* index = chunk.index.data();
    const double* weight = chunk.weight.data();
    for (int k = row_[i].first; k < row_[i].last; ++k) f(index[k], Vec<D>(s.position[index[k]] - ri), weight[k]);
  }

  /// The j of all pairs of i.
  std::span<const int> operator[](int i) const {
    const int* index = chunk_[i / chunk_rows].index.data();
    return {index + row_[i].first, index + row_[i].last};
  }

 private:
  struct Row {
    int first, last;  ///< of its chunk's pairs
  };
  struct Chunk {
    std::vector<int> index;
    Scalars weight;
    double least_squared;  ///< r^2 of its closest pair [m^2]
  };

  /// Writes the pairs of row i into the chunk from place `out` on; returns the place after them.
  template <class K>
  static int add_row(K w, std::span<const int> row, const State<D>& s, int i, Chunk& chunk, int out) {
    const Vec<D> ri = s.position[i];
    const double reach = w.support * w.support;
    int* const index = chunk.index.data();
    double* const weights = chunk.weight.data();
    // In blocks, first all that several pairs can share one instruction for, then what each does alone.
    constexpr int block = 64;
    double squared[block], weight[block], least = chunk.least_squared;
    for (int begin = 0; begin < static_cast<int>(row.size()); begin += block) {
      const int* js = row.data() + begin;
      const int count = std::min(block, static_cast<int>(row.size()) - begin);
#pragma omp simd reduction(min : least)
      for (int m = 0; m < count; ++m) {
        const double r2 = squared_distance<D>(s.position, js[m], ri);
        least = std::min(least, r2);
        squared[m] = r2;
        weight[m] = w(std::sqrt(r2)) / r2;
      }
      // Written whether it counts or not: a third of the pairs don't, at random, which no branch would foresee.
      for (int m = 0; m < count; ++m) {
        index[out] = js[m];
        weights[out] = weight[m];
        out += squared[m] < reach;
      }
    }
    chunk.least_squared = least;
    return out;
  }

  std::vector<Row> row_;
  std::vector<Chunk> chunk_;  ///< pairs of each chunk of rows, with room for all that are listed
};

}  // namespace seiche::solver
