#pragma once
#include <omp.h>

#include <algorithm>
#include <span>

#include "solver/particles/cell_grid.hpp"
#include "solver/particles/chunks.hpp"
#include "solver/particles/drift.hpp"
#include "solver/particles/kept.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// The one neighbour list of a step, shared by all operators. Row i names every j != i that was within
/// radius + skin when the list was made, in rising order; it holds every pair within `radius` until particles that were
/// near each other have come nearer by the skin, but those that baffles hid from each other when it was made. Dummy
/// particles have empty rows: nothing is computed at them.
template <int D>
class Neighbours {
 public:
  Neighbours(const Vec<D>& low, const Vec<D>& high, double radius, double skin)
      : radius_(radius), skin_(skin), grid_(low, high, radius + skin) {}

  double radius() const { return radius_; }
  std::span<const int> operator[](int i) const {
    const int* chunk = chunk_[i / chunk_rows].data();
    return {chunk + row_[i].first, chunk + row_[i].last};
  }
  const CellGrid<D>& grid() const { return grid_; }
  int rows() const { return static_cast<int>(row_.size()); }
  /// Entries of all rows of a chunk.
  std::size_t entries(int chunk) const { return chunk_[chunk].size(); }

  bool is_stale(const State<D>& s) {
    if (s.listed_position.size() != s.size()) return true;
    // Pairs that the drift doesn't look at were two cells apart, 2 (radius + skin).
    return drift_.exceeds(skin_, 0.5 * radius_ + skin_, grid_, s);
  }

  /// Sorts the state by cell and lists its pairs.
  void build(State<D>& s) {
    grid_.sort(s.position, order_);
    s.reorder(order_);
    s.listed_position = s.position;
    const int n = static_cast<int>(s.size());
    resize_kept(row_, n);
    resize_kept(chunk_, chunks_of(n));
    found_.resize(std::max<std::size_t>(found_.size(), omp_get_max_threads()));
    each_chunk<2>(n, [&](int first, int last) {
      std::vector<int>& found = found_[omp_get_thread_num()];
      int count = 0;
      for (int i = first; i < last; ++i) {
        row_[i].first = count;
        if (s.kind[i] != Kind::dummy) count = add_row(s, i, found, count);
        if (s.baffles) count = drop_hidden(s, i, found, row_[i].first, count);
        row_[i].last = count;
      }
      std::vector<int>& kept = chunk_[first / chunk_rows];
      resize_kept(kept, count);
      std::copy_n(found.begin(), count, kept.begin());
    });
  }

 private:
  struct Row {
    int first, last;  ///< of its chunk's entries
  };

  /// Writes row i into `found` from place `count` on; returns the place after it.
  int add_row(const State<D>& s, int i, std::vector<int>& found, int count) const {
    const Vec<D> ri = s.position[i];
    const double reach = (radius_ + skin_) * (radius_ + skin_);
    grid_.runs_near(ri, [&](int first, int last) {
      if (found.size() < static_cast<std::size_t>(count + last - first)) found.resize(2 * (count + last - first));
      constexpr int block = 32;
      double squared[block];
      int* const index = found.data();
      int out = count;
      for (int begin = first; begin < last; begin += block) {
        const int size = std::min(block, last - begin);
#pragma omp simd
        for (int m = 0; m < size; ++m) squared[m] = squared_distance<D>(s.position, begin + m, ri);
        // Written whether it counts or not: two thirds don't, which no branch would foresee.
        for (int m = 0; m < size; ++m) {
          index[out] = begin + m;
          out += (squared[m] < reach) & (begin + m != i);
        }
      }
      count = out;
    });
    return count;
  }

  /// Takes what i doesn't see out of its row, the entries from `first` to `count`; returns the place after those left.
  int drop_hidden(const State<D>& s, int i, std::vector<int>& found, int first, int count) const {
    // What stands behind a face is no farther from it than a pair reaches.
    if (first == count || !s.baffles->is_near(s.position[i], 2 * (radius_ + skin_))) return count;
    const auto hidden = [&](int j) { return !s.baffles->sees(s.position[i], s.behind[i], s.position[j], s.behind[j]); };
    const auto end = std::remove_if(found.begin() + first, found.begin() + count, hidden);
    return static_cast<int>(end - found.begin());
  }

  double radius_, skin_;
  CellGrid<D> grid_;
  Drift<D> drift_;
  std::vector<int> order_;
  std::vector<Row> row_;
  std::vector<std::vector<int>> chunk_, found_;  ///< entries of each chunk of rows; each thread's buffer
};

}  // namespace seiche::solver
