#include "render/picture/tank_section.hpp"

#include <algorithm>
#include <limits>

namespace seiche::render {

TankSection::TankSection(const RunInfo& run)
    : highest_(run.closed ? std::numeric_limits<double>::infinity()
                          : run.tank.high()[1] - 1e-9 * std::max(1.0, run.tank.size()[1])) {
  const auto at = [&](int k) { return Eigen::Vector2d(run.tank.points[static_cast<std::size_t>(k)].data()); };
  for (const SurfaceMesh::Patch& patch : run.tank.patches)
    for (const auto& face : patch.faces) wall_.push_back({at(face[0]), at(face[1])});
}

std::vector<double> TankSection::crossings(double y) const {
  y = std::min(y, highest_);
  std::vector<double> all;
  for (const auto& [from, to] : wall_)
    if ((from[1] > y) != (to[1] > y)) all.push_back(from[0] + (y - from[1]) / (to[1] - from[1]) * (to[0] - from[0]));
  std::sort(all.begin(), all.end());
  return all;
}

bool TankSection::holds(double x, double y) const {
  const auto all = crossings(y);
  return (std::upper_bound(all.begin(), all.end(), x) - all.begin()) % 2 == 1;
}

std::vector<std::array<Eigen::Vector2d, 4>> TankSection::quadrilaterals(double top) const {
  std::vector<double> levels{top};
  for (const Segment& segment : wall_)
    for (const double y : {segment.from[1], segment.to[1]})
      if (y < top) levels.push_back(y);
  std::sort(levels.begin(), levels.end());
  std::vector<std::array<Eigen::Vector2d, 4>> all;
  for (std::size_t k = 0; k + 1 < levels.size(); ++k) {
    const double low = levels[k], high = levels[k + 1], middle = std::min(0.5 * (low + high), highest_);
    if (!(high - low > 1e-9 * (levels.back() - levels.front()))) continue;
    struct Side {
      double middle, low, high;
    };
    std::vector<Side> sides;
    for (const auto& [from, to] : wall_) {
      if ((from[1] > middle) == (to[1] > middle)) continue;
      const auto x = [&, a = from, b = to](double y) {
        return a[0] + (std::min(y, highest_) - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
      };
      sides.push_back({x(middle), x(low), x(high)});
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.middle < b.middle; });
    for (std::size_t c = 0; c + 1 < sides.size(); c += 2)
      all.push_back({Eigen::Vector2d(sides[c].low, low), Eigen::Vector2d(sides[c + 1].low, low),
                     Eigen::Vector2d(sides[c + 1].high, high), Eigen::Vector2d(sides[c].high, high)});
  }
  return all;
}

Eigen::Vector2d TankSection::nearest_normal(const Eigen::Vector2d& r) const {
  double least = std::numeric_limits<double>::infinity();
  Eigen::Vector2d normal = Eigen::Vector2d::UnitY();
  for (const auto& [from, to] : wall_) {
    const Eigen::Vector2d way = to - from;
    const double share = std::clamp(way.dot(r - from) / way.squaredNorm(), 0.0, 1.0);
    const double squared = (from + share * way - r).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    normal = Eigen::Vector2d(way[1], -way[0]).normalized();
  }
  return normal;
}

}  // namespace seiche::render
