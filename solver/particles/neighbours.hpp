#pragma once
#include <span>

#include "solver/particles/cell_grid.hpp"
#include "solver/particles/chunks.hpp"
#include "solver/particles/drift.hpp"
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

  bool is_stale(const State<D>& s);

  /// Sorts the state by cell and lists its pairs.
  void build(State<D>& s);

 private:
  struct Row {
    int first, last;  ///< of its chunk's entries
  };

  /// Writes row i into `found` from place `count` on; returns the place after it.
  int add_row(const State<D>& s, int i, std::vector<int>& found, int count) const;

  /// Takes what i doesn't see out of its row, the entries from `first` to `count`; returns the place after those left.
  int drop_hidden(const State<D>& s, int i, std::vector<int>& found, int first, int count) const;

  double radius_, skin_;
  CellGrid<D> grid_;
  Drift<D> drift_;
  std::vector<int> order_;
  std::vector<Row> row_;
  std::vector<std::vector<int>> chunk_, found_;  ///< entries of each chunk of rows; each thread's buffer
};

}  // namespace seiche::solver
