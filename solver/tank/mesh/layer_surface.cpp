#include "solver/tank/mesh/layer_surface.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

namespace seiche::solver {
namespace {

/// The shortest vector that is as far behind all planes, about: least squares of normal . v = 1.
Vec<3> behind_all(const Vecs<3>& normals) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  Vec<3> right = Vec<3>::Zero();
  for (const Vec<3>& normal : normals) {
    sum += normal * normal.transpose();
    right += normal;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  Vec<3> v = Vec<3>::Zero();
  for (int k = 0; k < 3; ++k)
    if (solver.eigenvalues()[k] > 0.02 * solver.eigenvalues()[2])
      v += solver.eigenvectors().col(k).dot(right) / solver.eigenvalues()[k] * solver.eigenvectors().col(k);
  return v;
}

/// Lines along a graph, from one end to another, ends being where other than two lines meet or where they turn.
class Lines {
 public:
  Lines(const Vecs<3>& points, const std::vector<Crease>& creases) : points_(points) {
    for (const Crease& crease : creases) {
      if (crease.turn < 0) continue;
      next_[crease.low].push_back(crease.high);
      next_[crease.high].push_back(crease.low);
    }
  }

  std::vector<std::vector<int>> all() {
    std::vector<std::vector<int>> lines;
    for (const auto& [point, others] : next_)
      if (is_end(point))
        for (const int other : others)
          if (!walked({point, other})) lines.push_back(walk(point, other));
    for (const auto& [point, others] : next_)
      for (const int other : others)
        if (!walked({point, other})) lines.push_back(walk(point, other));
    return lines;
  }

 private:
  bool is_end(int point) const {
    const auto& others = next_.at(point);
    if (others.size() != 2) return true;
    const Vec<3> before = points_[point] - points_[others[0]], after = points_[others[1]] - points_[point];
    return before.dot(after) < std::cos(least_turn) * before.norm() * after.norm();
  }

  bool walked(std::pair<int, int> step) const {
    return walked_.count({std::min(step.first, step.second), std::max(step.first, step.second)}) > 0;
  }

  std::vector<int> walk(int from, int to) {
    std::vector<int> line{from};
    while (true) {
      walked_[{std::min(line.back(), to), std::max(line.back(), to)}] = true;
      const int before = line.back();
      line.push_back(to);
      if (to == from || is_end(to)) return line;
      const auto& others = next_.at(to);
      to = others[0] == before ? others[1] : others[0];
    }
  }

  const Vecs<3>& points_;
  std::map<int, std::vector<int>> next_;
  std::map<std::pair<int, int>, bool> walked_;
};

/// Points along a broken line, its ends with them, or all round a closed one.
Vecs<3> steps_along(const Vecs<3>& line, double spacing) {
  double length = 0;
  for (std::size_t k = 1; k < line.size(); ++k) length += (line[k] - line[k - 1]).norm();
  const double step = length / std::max(1.0, std::round(length / spacing));
  Vecs<3> points{line.front(), line.back()};
  double ahead = step;  // to the next point, from the beginning of a piece
  for (std::size_t k = 1; k < line.size(); ++k) {
    const Vec<3> way = line[k] - line[k - 1];
    const double piece = way.norm();
    for (; ahead < piece - 0.01 * step; ahead += step) points.push_back(line[k - 1] + ahead / piece * way);
    ahead -= piece;
  }
  return points;
}

}  // namespace

std::optional<Vec<3>> LayerSurface::place(Vec<3> r) const {
  for (int round = 0; round < 40; ++round) {
    const Depth depth = wall_->depth(r);
    if (std::abs(depth.at - depth_) < 1e-9 * depth_) return r;
    const Vec<3> off = r - depth.foot.at;
    // What lies beyond the foot is as deep as it is far, in any direction.
    if (depth.at > 1e-3 * depth_)
      r = depth.foot.at + depth_ / depth.at * off;
    else
      r = depth.foot.at + depth_ * depth.way;
  }
  return {};
}

std::optional<Vec<3>> LayerSurface::behind(int point) const {
  const Vec<3>& at = wall_->mesh().points[point];
  const auto placed = place(at + depth_ * behind_all(wall_->creases().normals_at(point)));
  if (!placed || (*placed - at).norm() > 1.01 * point_mitre * depth_) return {};
  return placed;
}

Vecs<3> LayerSurface::mitre_points(double spacing) const {
  Vecs<3> ends, between;
  for (const auto& line : Lines(wall_->mesh().points, wall_->creases().all()).all()) {
    Vecs<3> behind_line;
    for (const int point : line)
      if (const auto placed = behind(point)) behind_line.push_back(*placed);
    if (behind_line.size() < 2) continue;
    const Vecs<3> steps = steps_along(behind_line, spacing);
    ends.insert(ends.end(), steps.begin(), steps.begin() + 2);
    for (std::size_t k = 2; k < steps.size(); ++k)
      if (const auto placed = place(steps[k]); placed && (*placed - steps[k]).norm() < 0.3 * spacing)
        between.push_back(*placed);
  }
  ends.insert(ends.end(), between.begin(), between.end());
  return ends;
}

}  // namespace seiche::solver
