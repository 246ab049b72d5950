#pragma once
#include <algorithm>
#include <numeric>

#include "solver/operators/kernels.hpp"
#include "solver/sensors/fluid_cells.hpp"

namespace seiche::solver {

/// The water surface over the columns of the lattice: for each the highest crossing of half of the fluid fraction
///   phi(x, y) = sum_fluid W((x - x_j)/l0) W((y - y_j)/l0)   (and so along z),
/// W being KF4 of support 2, whose copies one spacing apart add up to 1 everywhere: a lattice at rest has phi = 1 below
/// its surface, 1/2 on it and 0 above. The fluid is continued behind the side walls and the floor as in a mirror, so
/// that walls take nothing away. Spray, fluid at the free surface with fewer than two fluid neighbours within 1.5 l0,
/// doesn't count.
template <int D>
class SurfaceProfile {
 public:
  explicit SurfaceProfile(const Parameters& p) : SurfaceProfile(*make_shape<D>(p), p.particles.spacing) {}
  SurfaceProfile(const Shape<D>& tank, double l0) : size_(tank.bounds().size()), closed_(tank.is_closed()), l0_(l0) {
    count_[0] = static_cast<int>(std::lround(size_[0] / l0_));
    if (D == 3) count_[1] = static_cast<int>(std::lround(size_[D - 1] / l0_));
    height_.resize(count_[0] * count_[1]);
  }

  /// Finds the surface. Second order in l0.
  void find(const State<D>& s, const FluidCells<D>& cells) {
    sort(s, cells);
    const int columns = static_cast<int>(height_.size());
#pragma omp parallel for schedule(static)
    for (int c = 0; c < columns; ++c) height_[c] = crossing(c);
  }

  /// Columns along x, and along z (1 in 2-D); column (i, k) stands at ((i + 1/2) l0, (k + 1/2) l0).
  int count(int axis) const { return count_[axis]; }

  /// Surface above the floor [m], 0 where there is no water, of column i + count(0) k.
  double height(int column) const { return height_[column]; }

  /// Space below the surface [m^2 in 2-D, m^3].
  double volume() const { return std::accumulate(height_.begin(), height_.end(), 0.0) * std::pow(l0_, D - 1); }

 private:
  /// Sorts the water by column, topmost first.
  void sort(const State<D>& s, const FluidCells<D>& cells) {
    const int columns = static_cast<int>(height_.size()), size = static_cast<int>(s.size());
    column_.assign(size, -1);
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i)
      if (s.kind[i] == Kind::fluid && !is_spray(s, i, cells)) column_[i] = column_of(s.position[i]);
    start_.assign(columns + 1, 0);
    for (int c : column_)
      if (c >= 0) ++start_[c + 1];
    for (int c = 0; c < columns; ++c) start_[c + 1] += start_[c];
    water_.resize(start_[columns]);
    next_.assign(start_.begin(), start_.end() - 1);
    for (int i = 0; i < size; ++i)
      if (column_[i] >= 0) water_[next_[column_[i]]++] = s.position[i];
#pragma omp parallel for schedule(static)
    for (int c = 0; c < columns; ++c)
      std::sort(water_.begin() + start_[c], water_.begin() + start_[c + 1],
                [](const Vec<D>& a, const Vec<D>& b) { return a[1] > b[1]; });
  }

  bool is_spray(const State<D>& s, int i, const FluidCells<D>& cells) const {
    if (!s.surface[i]) return false;
    int close = 0;
    cells.near(s.position[i], [&](int j, const Vec<D>& offset) { close += j != i && offset.norm() < 1.5 * l0_; });
    return close < 2;
  }

  int column_of(const Vec<D>& r) const {
    const auto cell = [&](double x, int n) { return std::clamp(static_cast<int>(std::floor(x / l0_)), 0, n - 1); };
    return cell(r[0], count_[0]) + (D == 3 ? count_[0] * cell(r[D - 1], count_[1]) : 0);
  }

  /// Calls f(first, last) for the water of every column within two of column c.
  template <class F>
  void around(int c, F f) const {
    const int i = c % count_[0], k = c / count_[0];
    for (int z = std::max(0, k - 2); z <= std::min(count_[1] - 1, k + 2); ++z)
      for (int x = std::max(0, i - 2); x <= std::min(count_[0] - 1, i + 2); ++x)
        f(start_[x + count_[0] * z], start_[x + count_[0] * z + 1]);
  }

  double crossing(int c) const {
    double top = 0;
    around(c, [&](int first, int last) { top = first < last ? std::max(top, water_[first][1]) : top; });
    const double dy = 0.25 * l0_;
    double above = 0;
    for (double y = top + 2 * l0_; y > 0; y -= dy) {
      const double here = fraction(c, y);
      if (here >= 0.5) {
        const double level = y + dy * (here - 0.5) / (here - above);
        return closed_ ? std::min(level, size_[1]) : level;
      }
      above = here;
    }
    return 0;
  }

  double fraction(int c, double y) const {
    double sum = 0;
    around(c, [&](int first, int last) {
      for (int j = first; j < last && water_[j][1] > y - 2 * l0_; ++j) {
        const Vec<D>& r = water_[j];
        const double up = w(r[1] - y) + w(r[1] + y);
        if (up > 0) sum += up * across(r, 0, c % count_[0]) * (D == 3 ? across(r, D - 1, c / count_[0]) : 1);
      }
    });
    return sum;
  }

  /// Weight of a particle and of its mirror images behind the walls, along one axis, for column number `at`.
  double across(const Vec<D>& r, int axis, int at) const {
    const double x = (at + 0.5) * l0_;
    return w(r[axis] - x) + w(r[axis] + x) + w(2 * size_[axis] - r[axis] - x);
  }

  double w(double distance) const { return KF4{2}(std::abs(distance) / l0_); }

  Vec<D> size_;  ///< of the tank [m]
  bool closed_;
  double l0_;
  int count_[2] = {1, 1};
  Scalars height_;
  std::vector<int> column_, start_, next_;  ///< of each particle (-1: no water); of each column in `water_`; a buffer
  Vecs<D> water_;
};

}  // namespace seiche::solver
