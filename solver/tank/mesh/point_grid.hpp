#pragma once
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "solver/particles/vec.hpp"

namespace seiche::solver {

/// Points that come one after the other, sorted into cells.
class PointGrid {
 public:
  /// @param cell as long as the greatest distance that is asked for [m]
  explicit PointGrid(double cell) : cell_(cell) {}

  void add(const Vec<3>& r) {
    cells_[key(cell(r))].push_back(static_cast<int>(points_.size()));
    points_.push_back(r);
  }

  const Vecs<3>& points() const { return points_; }

  /// Calls f(number, squared distance) of all points that are nearer to r than a cell is long, and of some others.
  template <class F>
  void near(const Vec<3>& r, F f) const {
    const Eigen::Vector3i middle = cell(r);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const auto at = cells_.find(key(middle + Eigen::Vector3i(x, y, z))); at != cells_.end())
            for (const int k : at->second) f(k, (points_[k] - r).squaredNorm());
  }

  /// The point nearest to r; -1 if none is nearer than a distance.
  int nearest(const Vec<3>& r, double within) const {
    int best = -1;
    double least = within * within;
    near(r, [&](int k, double squared) {
      if (squared < least) least = squared, best = k;
    });
    return best;
  }

 private:
  Eigen::Vector3i cell(const Vec<3>& r) const { return (r / cell_).array().floor().cast<int>().matrix(); }
  static std::uint64_t key(const Eigen::Vector3i& cell) {
    std::uint64_t key = 0;
    for (int a = 0; a < 3; ++a) key = key << 21 | (static_cast<std::uint64_t>(cell[a]) & 0x1fffff);
    return key;
  }

  double cell_;
  Vecs<3> points_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

}  // namespace seiche::solver
