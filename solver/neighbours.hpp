#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "solver/state.hpp"

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
    start_.assign(cells() + 1, 0);
    cell_of_.resize(n);
    order.resize(n);
    for (int i = 0; i < n; ++i) ++start_[(cell_of_[i] = cell(coordinates(r[i]))) + 1];
    for (int c = 0; c < cells(); ++c) start_[c + 1] += start_[c];
    next_.assign(start_.begin(), start_.end() - 1);
    for (int i = 0; i < n; ++i) order[next_[cell_of_[i]]++] = i;
  }

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

/// The one neighbour list of a step, shared by all operators. Row i names every j != i that was within
/// radius + skin when the list was made, in rising order; it holds every pair within `radius` until some particle has
/// moved by half the skin. Dummy particles have empty rows: nothing is computed at them.
template <int D>
class Neighbours {
 public:
  Neighbours(const Vec<D>& low, const Vec<D>& high, double radius, double skin)
      : radius_(radius), skin_(skin), grid_(low, high, radius + skin) {}

  double radius() const { return radius_; }
  std::span<const int> operator[](int i) const { return {index_.data() + start_[i], index_.data() + start_[i + 1]}; }
  const CellGrid<D>& grid() const { return grid_; }
  /// Entries of all rows, and of those before row i.
  int capacity() const { return static_cast<int>(index_.size()); }
  int offset(int i) const { return start_[i]; }

  bool is_stale(const State<D>& s) const {
    if (s.listed_position.size() != s.size()) return true;
    double moved = 0;
    const int n = static_cast<int>(s.size());
#pragma omp parallel for schedule(static) reduction(max : moved)
    for (int i = 0; i < n; ++i) moved = std::max(moved, (s.position[i] - s.listed_position[i]).squaredNorm());
    return !(moved <= 0.25 * skin_ * skin_);
  }

  /// Sorts the state by cell and lists its pairs.
  void build(State<D>& s) {
    grid_.sort(s.position, order_);
    s.reorder(order_);
    s.listed_position = s.position;
    const int n = static_cast<int>(s.size());
    start_.assign(n + 1, 0);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i) {
      int count = 0;
      each_near(s, i, [&](int) { ++count; });
      start_[i + 1] = count;
    }
    for (int i = 0; i < n; ++i) start_[i + 1] += start_[i];
    index_.resize(start_[n]);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < n; ++i) {
      int* out = index_.data() + start_[i];
      each_near(s, i, [&](int j) { *out++ = j; });
    }
  }

 private:
  template <class F>
  void each_near(const State<D>& s, int i, F f) const {
    if (s.kind[i] == Kind::dummy) return;
    const Vec<D> ri = s.position[i];
    const double reach = (radius_ + skin_) * (radius_ + skin_);
    grid_.runs_near(ri, [&](int first, int last) {
      for (int j = first; j < last; ++j)
        if ((s.position[j] - ri).squaredNorm() < reach && j != i) f(j);
    });
  }

  double radius_, skin_;
  CellGrid<D> grid_;
  std::vector<int> order_, start_, index_;
};

}  // namespace seiche::solver
