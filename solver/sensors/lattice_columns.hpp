#pragma once
#include <algorithm>
#include <cmath>

#include "solver/operators/kernels.hpp"
#include "solver/tank/liquid_cells.hpp"

namespace seiche::solver {

/// Points with weights, sorted into the columns of a lattice, and their sums about places on the columns' axes:
///   sum_j v_j W((x - x_j)/l0) W((y - y_j)/l0)   (and so along z),
/// W being KF4 of support 2, whose copies one spacing apart add up to 1 everywhere. Points up to two columns beside the
/// lattice count, too.
template <int D>
class LatticeColumns {
 public:
  explicit LatticeColumns(const LiquidLattice<D>& lattice) : corner_(lattice.corner), l0_(lattice.l0) {
    count_[0] = lattice.count[0] + 2 * beside;
    if (D == 3) count_[1] = lattice.count[D - 1] + 2 * beside;
  }

  void clear() { points_.clear(); }

  void add(const Vec<D>& r, double weight) {
    const int i = cell(r, 0), k = D == 3 ? cell(r, D - 1) : 0;
    if (i >= 0 && i < count_[0] && k >= 0 && k < count_[1]) points_.push_back({i + count_[0] * k, weight, r});
  }

  /// Call after the last of them.
  void sort() {
    start_.assign(count_[0] * count_[1] + 1, 0);
    for (const Point& point : points_) ++start_[point.column + 1];
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    next_.assign(start_.begin(), start_.end() - 1);
    by_column_.resize(points_.size());
    // From the last on: cells of the state go upwards, so each column is nearly sorted then.
    for (std::size_t i = points_.size(); i-- > 0;) by_column_[next_[points_[i].column]++] = points_[i];
    points_.swap(by_column_);
    for (std::size_t c = 1; c < start_.size(); ++c)
      std::sort(points_.begin() + start_[c - 1], points_.begin() + start_[c],
                [](const Point& a, const Point& b) { return a.r[1] > b.r[1]; });
  }

  /// Height of the topmost point within two columns of column (i, k), `none` if there is none [m].
  double top(int i, int k, double none) const {
    double highest = none;
    around(i, k, beside, [&](const Point* first, const Point* last) {
      if (first < last) highest = std::max(highest, first->r[1]);
    });
    return highest;
  }

  /// Of the points in their sorted order.
  std::size_t size() const { return points_.size(); }
  const Vec<D>& position(std::size_t i) const { return points_[i].r; }
  double weight(std::size_t i) const { return points_[i].weight; }
  void set_weight(std::size_t i, double weight) { points_[i].weight = weight; }

  /// On the axis of column (i, k) at height y.
  double sum(int i, int k, double y) const {
    double all = 0;
    around(i, k, beside, [&](const Point* first, const Point* last) {
      first = std::partition_point(first, last, [&](const Point& point) { return point.r[1] > y + 2 * l0_; });
      for (; first < last && first->r[1] > y - 2 * l0_; ++first)
        all += first->weight * w(first->r[1] - y) * w(first->r[0] - axis(i, 0)) *
               (D == 3 ? w(first->r[D - 1] - axis(k, D - 1)) : 1);
    });
    return all;
  }

  /// The same at any place.
  double sum(const Vec<D>& r) const {
    double all = 0;
    around(cell(r, 0) - beside, D == 3 ? cell(r, D - 1) - beside : 0, beside,
           [&](const Point* first, const Point* last) {
             first = std::partition_point(first, last, [&](const Point& point) { return point.r[1] > r[1] + 2 * l0_; });
             for (; first < last && first->r[1] > r[1] - 2 * l0_; ++first) {
               double weight = first->weight;
               for (int a = 0; a < D; ++a) weight *= w(first->r[a] - r[a]);
               all += weight;
             }
           });
    return all;
  }

  /// sum_j v_j prod_axis max(0, 1 - |r_j - r|/l0) at any place.
  double linear_sum(const Vec<D>& r) const {
    double all = 0;
    around(cell(r, 0) - beside, D == 3 ? cell(r, D - 1) - beside : 0, 1, [&](const Point* first, const Point* last) {
      first = std::partition_point(first, last, [&](const Point& point) { return point.r[1] >= r[1] + l0_; });
      for (; first < last && first->r[1] > r[1] - l0_; ++first)
        all += first->weight * (1 - (first->r - r).array().abs() / l0_).max(0.0).prod();
    });
    return all;
  }

 private:
  static constexpr int beside = 2;

  struct Point {
    int column;
    double weight;
    Vec<D> r;
  };

  int cell(const Vec<D>& r, int a) const { return static_cast<int>(std::floor((r[a] - corner_[a]) / l0_)) + beside; }
  double axis(int i, int a) const { return corner_[a] + (i + 0.5) * l0_; }
  double w(double distance) const { return KF4{2}(std::abs(distance) / l0_); }

  /// Calls f(first, last) for the points of every column within `reach` of column (i, k).
  template <class F>
  void around(int i, int k, int reach, F f) const {
    const auto first = [&](int at) { return std::max(0, at + beside - reach); };
    const auto last = [&](int at, int axis) { return std::min(count_[axis] - 1, at + beside + reach); };
    for (int z = D == 3 ? first(k) : 0; z <= (D == 3 ? last(k, 1) : 0); ++z)
      for (int x = first(i); x <= last(i, 0); ++x) {
        const int c = x + count_[0] * z;
        f(points_.data() + start_[c], points_.data() + start_[c + 1]);
      }
  }

  Vec<D> corner_;
  double l0_;
  int count_[2] = {1, 1};
  std::vector<Point> points_, by_column_;  ///< the latter a buffer
  std::vector<int> start_, next_;
};

}  // namespace seiche::solver
