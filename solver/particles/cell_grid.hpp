#pragma once
#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/particles/kept.hpp"
#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Sorts points into square cells no smaller than the search radius, so that all neighbours of a point lie in its own
/// cell and those around it. Points outside the box count for the cell nearest to them, which keeps that true.
template <int D>
class CellGrid {
 public:
  CellGrid(const Vec<D>& low, const Vec<D>& high, double radius) : low_(low), size_(radius) {
    for (int a = 0; a < D; ++a) count_[a] = std::max(1, static_cast<int>(std::floor((high[a] - low[a]) / radius)));
  }

  int cells() const { return count_.prod(); }
  const Eigen::Matrix<int, D, 1>& cells_along() const { return count_; }

  Eigen::Matrix<int, D, 1> coordinates(const Vec<D>& r) const {
    Eigen::Matrix<int, D, 1> c;
    for (int a = 0; a < D; ++a) {
      const double s = std::floor((r[a] - low_[a]) / size_);
      c[a] = s > 0 ? static_cast<int>(std::min(s, count_[a] - 1.0)) : 0;  // also for NaN
    }
    return c;
  }

  int cell(const Eigen::Matrix<int, D, 1>& c) const {
    int index = c[D - 1];
    for (int a = D - 2; a >= 0; --a) index = index * count_[a] + c[a];
    return index;
  }

  /// Stable counting sort: `order` lists the points by cell; cell c holds order[start[c]] .. order[start[c+1] - 1].
  void sort(const Vecs<D>& r, std::vector<int>& order) {
    const int n = static_cast<int>(r.size());
    assign_kept(start_, cells() + 1, 0);
    resize_kept(cell_of_, n);
    resize_kept(order, n);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i) cell_of_[i] = cell(coordinates(r[i]));
    for (int i = 0; i < n; ++i) ++start_[cell_of_[i] + 1];
    for (int c = 0; c < cells(); ++c) start_[c + 1] += start_[c];
    next_.assign(start_.begin(), start_.end() - 1);
    for (int i = 0; i < n; ++i) order[next_[cell_of_[i]]++] = i;
  }

  /// Sorted points of a cell: [first, last).
  std::pair<int, int> points(int cell) const { return {start_[cell], start_[cell + 1]}; }

  /// Calls f(first, last) for each run of sorted points that may lie within the search radius of r, in rising order.
  template <class F>
  void runs_near(const Vec<D>& r, F f) const {
    const auto c = coordinates(r);
    const int x0 = std::max(c[0] - 1, 0), x1 = std::min(c[0] + 1, count_[0] - 1);
    const int z0 = D == 3 ? std::max(c[D - 1] - 1, 0) : 0, z1 = D == 3 ? std::min(c[D - 1] + 1, count_[D - 1] - 1) : 0;
    for (int z = z0; z <= z1; ++z)
      for (int y = std::max(c[1] - 1, 0); y <= std::min(c[1] + 1, count_[1] - 1); ++y) {
        Eigen::Matrix<int, D, 1> a;
        a[D - 1] = z;
        a[1] = y;
        a[0] = x0;
        const int first = cell(a);
        f(start_[first], start_[first + x1 - x0 + 1]);
      }
  }

 private:
  Vec<D> low_;
  double size_;
  Eigen::Matrix<int, D, 1> count_;
  std::vector<int> start_, next_, cell_of_;
};

}  // namespace seiche::solver
