#include "solver/tank/mesh/creases.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace seiche::solver {
namespace {

double angle_between(const Vec<3>& a, const Vec<3>& b) { return std::atan2(cross(a, b).norm(), a.dot(b)); }

/// Numbers that are put together into groups.
class Groups {
 public:
  explicit Groups(int count) : leader_(count) { std::iota(leader_.begin(), leader_.end(), 0); }

  int of(int item) {
    while (leader_[item] != item) item = leader_[item] = leader_[leader_[item]];
    return item;
  }
  void join(int a, int b) { leader_[std::max(of(a), of(b))] = std::min(of(a), of(b)); }

 private:
  std::vector<int> leader_;
};

double corner_angle(const Triangles& mesh, int t, int k) {
  const Vec<3>& at = mesh.corner(t, k);
  return angle_between(mesh.corner(t, (k + 1) % 3) - at, mesh.corner(t, (k + 2) % 3) - at);
}

}  // namespace

Creases::Creases(const Triangles& mesh)
    : mesh_(&mesh),
      normals_(mesh.count(), Vec<3>::Zero()),
      at_points_(mesh.points.size(), Vec<3>::Zero()),
      at_corners_(3 * mesh.count(), Vec<3>::Zero()),
      beyond_(mesh.count(), {-1, -1, -1}),
      is_corner_(mesh.count(), {false, false, false}),
      has_corner_(mesh.points.size()),
      first_(mesh.points.size() + 1) {
  for (int t = 0; t < mesh.count(); ++t) {
    const Vec<3> area = mesh.area(t);
    if (!area.isZero()) normals_[t] = area.normalized();
    for (int k = 0; k < 3; ++k) at_points_[mesh.corners[t][k]] += corner_angle(mesh, t, k) * normals_[t];
  }
  Groups smooth(3 * mesh.count());
  for (const MeshEdge& edge : edges_of(mesh)) {
    if (edge.sides.size() != 2) continue;
    const Side &a = edge.sides[0], &b = edge.sides[1];
    beyond_[a.triangle][a.k] = b.triangle;
    beyond_[b.triangle][b.k] = a.triangle;
    const Vec<3>&na = normals_[a.triangle], &nb = normals_[b.triangle];
    const Vec<3> off = mesh.corner(b.triangle, (b.k + 2) % 3) - mesh.points[edge.low];
    const double turn = std::copysign(angle_between(na, nb), -off.dot(na));
    if (std::abs(turn) < least_turn) {
      smooth.join(3 * a.triangle + a.k, 3 * b.triangle + (b.k + 1) % 3);
      smooth.join(3 * a.triangle + (a.k + 1) % 3, 3 * b.triangle + b.k);
      continue;
    }
    creases_.push_back({edge.low, edge.high, turn, {na, nb}});
    if (turn < 0) continue;
    is_corner_[a.triangle][a.k] = is_corner_[b.triangle][b.k] = true;
    has_corner_[edge.low] = has_corner_[edge.high] = true;
  }
  Vecs<3> sums(at_corners_.size(), Vec<3>::Zero());
  for (int t = 0; t < mesh.count(); ++t)
    for (int k = 0; k < 3; ++k) sums[smooth.of(3 * t + k)] += corner_angle(mesh, t, k) * normals_[t];
  for (int t = 0; t < mesh.count(); ++t)
    for (int k = 0; k < 3; ++k) at_corners_[3 * t + k] = sums[smooth.of(3 * t + k)].normalized();

  for (const auto& corners : mesh.corners)
    for (const int point : corners) ++first_[point + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  around_.resize(3 * mesh.count());
  std::vector<int> next(first_.begin(), first_.end() - 1);
  for (int t = 0; t < mesh.count(); ++t)
    for (const int point : mesh.corners[t]) around_[next[point]++] = t;
}

Vec<3> Creases::pseudonormal(const Foot& foot) const {
  if (foot.on == Foot::On::corner) return at_points_[mesh_->corners[foot.triangle][foot.k]];
  const Vec<3>& own = normals_[foot.triangle];
  const int other = foot.on == Foot::On::side ? beyond_[foot.triangle][foot.k] : -1;
  return other < 0 ? own : Vec<3>(own + normals_[other]);
}

Vec<3> Creases::smooth_normal(const Foot& foot) const {
  const Vec<3>&a = mesh_->corner(foot.triangle, 0), &b = mesh_->corner(foot.triangle, 1),
        &c = mesh_->corner(foot.triangle, 2), &normal = normals_[foot.triangle];
  const double of_a = std::max(0.0, cross(b - foot.at, c - foot.at).dot(normal)),
               of_b = std::max(0.0, cross(c - foot.at, a - foot.at).dot(normal)),
               of_c = std::max(0.0, cross(a - foot.at, b - foot.at).dot(normal));
  const Vec<3>* corners = at_corners_.data() + 3 * foot.triangle;
  const Vec<3> sum = of_a * corners[0] + of_b * corners[1] + of_c * corners[2];
  return sum.isZero() ? normal : sum.normalized();
}

bool Creases::is_corner(const Foot& foot) const {
  if (foot.on == Foot::On::face) return false;
  if (foot.on == Foot::On::side) return is_corner_[foot.triangle][foot.k];
  return has_corner_[mesh_->corners[foot.triangle][foot.k]];
}

Vecs<3> Creases::normals_at(const Foot& foot) const {
  if (foot.on == Foot::On::corner) return normals_at(mesh_->corners[foot.triangle][foot.k]);
  Vecs<3> normals{normals_[foot.triangle]};
  const int other = foot.on == Foot::On::side ? beyond_[foot.triangle][foot.k] : -1;
  if (other >= 0) normals.push_back(normals_[other]);
  return normals;
}

Vecs<3> Creases::normals_at(int point) const {
  Vecs<3> normals;
  for (int k = first_[point]; k < first_[point + 1]; ++k) {
    const Vec<3>& one = normals_[around_[k]];
    const auto same = [&](const Vec<3>& other) { return (one - other).squaredNorm() < 1e-12; };
    if (std::none_of(normals.begin(), normals.end(), same) && !one.isZero()) normals.push_back(one);
  }
  return normals;
}

}  // namespace seiche::solver
