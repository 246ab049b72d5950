#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "solver/run_info.hpp"

namespace seiche::render {

/// The inside of a 2-D tank, in its frame. An open tank goes on above its rim.
class TankSection {
 public:
  explicit TankSection(const RunInfo& run);

  /// Where the line at that height enters the inside, leaves it, enters it again, ... from left to right [m].
  std::vector<double> crossings(double y) const;

  bool holds(double x, double y) const;

  /// All of it below a height, in quadrilaterals whose lower and upper sides are level.
  std::vector<std::array<Eigen::Vector2d, 4>> quadrilaterals(double top) const;

  /// Of the wall that is nearest to a point, out of the tank.
  Eigen::Vector2d nearest_normal(const Eigen::Vector2d& r) const;

 private:
  struct Segment {
    Eigen::Vector2d from, to;  ///< the inside on the left of the way
  };
  std::vector<Segment> wall_;
  double highest_;  ///< level above which the inside is as it is there: the rim of an open tank [m]
};

}  // namespace seiche::render
