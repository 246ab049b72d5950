#include "solver/tank/mesh/holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"
#include "solver/tank/box_tree.hpp"
#include "solver/tank/mesh/edges.hpp"

namespace seiche::solver {
namespace {

/// Steps into which the size of a hole is split to look for its middle.
constexpr int steps = 24;

Bounds<3> box_of(const Vec<3>& a, const Vec<3>& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

double squared_to_line(const Vec<3>& a, const Vec<3>& b, const Vec<3>& r) {
  const Vec<3> way = b - a;
  const double along = std::clamp((r - a).dot(way) / way.squaredNorm(), 0.0, 1.0);
  return (r - a - along * way).squaredNorm();
}

/// The distance to the edge of a hole.
class Rim {
 public:
  Rim(const Triangles& mesh, const HoleLoop& loop) {
    std::vector<Bounds<3>> boxes;
    for (std::size_t k = 0; k < loop.size(); ++k) {
      points_.push_back(mesh.points[loop[k]]);
      boxes.push_back(box_of(points_.back(), mesh.points[loop[(k + 1) % loop.size()]]));
    }
    tree_ = BoxTree<3>(boxes);
  }

  double squared_distance(const Vec<3>& r) const {
    double least = std::numeric_limits<double>::infinity();
    tree_.search(r, [&](int k) {
      const auto next = (static_cast<std::size_t>(k) + 1) % points_.size();
      return least = std::min(least, squared_to_line(points_[k], points_[next], r));
    });
    return least;
  }

  double diameter() const {
    Bounds<3> all = box_of(points_[0], points_[0]);
    for (const Vec<3>& r : points_) all = {all.low.cwiseMin(r), all.high.cwiseMax(r)};
    return all.size().norm();
  }

 private:
  Vecs<3> points_;
  BoxTree<3> tree_;
};

/// Which triangle closes a hole, by the patches round it: that which the most of its sides have.
int patch_round(const std::vector<int>& patches) {
  int best = patches.front();
  for (const int patch : patches)
    if (std::count(patches.begin(), patches.end(), patch) > std::count(patches.begin(), patches.end(), best))
      best = patch;
  return best;
}

}  // namespace

HoleSize size_of(const Triangles& mesh, const HoleLoop& loop, const std::vector<std::array<int, 3>>& ears) {
  const Rim rim(mesh, loop);
  const double step = rim.diameter() / steps;
  HoleSize size;
  double most = 0;
  for (const auto& ear : ears) {
    const Vec<3>&a = mesh.points[loop[ear[0]]], &b = mesh.points[loop[ear[1]]], &c = mesh.points[loop[ear[2]]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int parts = std::clamp(static_cast<int>(std::ceil(longest / step)), 3, steps);
    for (int i = 0; i <= parts; ++i)
      for (int j = 0; i + j <= parts; ++j) {
        const Vec<3> r = a + (i * (b - a) + j * (c - a)) / parts;
        const double squared = rim.squared_distance(r);
        if (squared > most) most = squared, size = {2 * std::sqrt(squared), r};
      }
  }
  return size;
}

Holes close_holes(Triangles& mesh, double widest) {
  std::vector<int> patch_at(mesh.points.size(), 0);
  Holes holes;
  for (const MeshEdge& edge : edges_of(mesh))
    if (edge.sides.size() == 1) {
      ++holes.open_sides;
      patch_at[end_of(mesh, edge.sides[0])] = mesh.patch[edge.sides[0].triangle];
    }
  HoleSize worst;
  int too_wide = 0;
  for (const HoleLoop& loop : loops_of(mesh)) {
    const auto ears = ears_of(mesh, loop);
    const HoleSize size = size_of(mesh, loop, ears);
    too_wide += size.width > widest;
    if (size.width > worst.width) worst = size;
    std::vector<int> patches;
    for (const int point : loop) patches.push_back(patch_at[point]);
    const int patch = patch_round(patches);
    for (const auto& [a, b, c] : ears) mesh.add({loop[a], loop[b], loop[c]}, patch);
    ++holes.count;
  }
  holes.widest = worst.width;
  if (too_wide > 0)
    throw BadParameters(fmt::format(
        "the mesh has {} wider than {:.3g} m, a spacing of particles; the widest is {:.3g} m wide, its middle at "
        "({:.6g}, {:.6g}, {:.6g}) m: close it in the program that made the mesh",
        too_wide > 1 ? fmt::format("{} holes", too_wide) : "a hole", widest, worst.width, worst.middle[0],
        worst.middle[1], worst.middle[2]));
  return holes;
}

}  // namespace seiche::solver
