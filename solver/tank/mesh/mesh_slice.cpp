#include "solver/tank/mesh/mesh_slice.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace seiche::solver {
namespace {

constexpr double straightness = 1e-7;  // of the mesh's size

/// Where a plane cuts a side of a triangle, by the side's ends.
using Cut = std::pair<int, int>;

/// A plane through a mesh; points in it count as beyond.
class Knife {
 public:
  Knife(const Triangles& mesh, const SectionPlane& plane)
      : mesh_(&mesh), axis_(static_cast<int>(plane.axis)), at_(plane.at) {}

  /// The line across a triangle. All round a section they run one way, the contour says which.
  struct Line {
    Cut from, to;
    int patch;
  };

  std::map<Cut, std::vector<Line>> lines() const {
    std::map<Cut, std::vector<Line>> all;
    for (int t = 0; t < mesh_->count(); ++t) {
      Cut enters, leaves;
      int cuts = 0;
      for (int k = 0; k < 3; ++k) {
        const int a = mesh_->corners[t][k], b = mesh_->corners[t][(k + 1) % 3];
        if (is_beyond(a) == is_beyond(b)) continue;
        (is_beyond(b) ? enters : leaves) = std::minmax(a, b);
        ++cuts;
      }
      if (cuts == 2) all[leaves].push_back({leaves, enters, mesh_->patch[t]});
    }
    return all;
  }

  /// In the run's x and y.
  Vec<2> at(const Cut& cut) const {
    const Vec<3>&a = mesh_->points[cut.first], &b = mesh_->points[cut.second];
    const double share = (at_ - a[axis_]) / (b[axis_] - a[axis_]);
    const Vec<3> r = a + share * (b - a);
    return {r[2 - axis_], r[1]};
  }

 private:
  bool is_beyond(int point) const { return mesh_->points[point][axis_] >= at_; }

  const Triangles* mesh_;
  int axis_;
  double at_;
};

/// Takes out corners that lie on the line between their neighbours, or on one of them, unless the patch changes there.
void straighten(std::vector<Edge>& loop, double tolerance) {
  std::vector<Edge> kept;
  for (const Edge& edge : loop) {
    if ((edge.to - edge.from).norm() <= tolerance) {
      if (!kept.empty()) kept.back().to = edge.to;
      continue;
    }
    kept.push_back(edge);
    while (kept.size() > 1) {
      const Edge &last = kept.back(), &before = kept[kept.size() - 2];
      const Vec<2> way = last.to - before.from;
      const bool goes_on = (before.to - before.from).dot(last.to - last.from) > 0;
      if (before.patch != last.patch || !goes_on) break;
      if (std::abs(cross(before.to - before.from, way)) > tolerance * way.norm()) break;
      kept[kept.size() - 2].to = last.to;
      kept.pop_back();
    }
  }
  for (std::size_t k = 0; k < kept.size(); ++k) kept[k].from = kept[(k + kept.size() - 1) % kept.size()].to;
  loop = std::move(kept);
}

std::vector<std::vector<Edge>> loops_in(const Knife& knife, double tolerance) {
  auto lines = knife.lines();
  std::vector<std::vector<Edge>> loops;
  while (!lines.empty()) {
    std::vector<Edge> loop;
    for (auto next = lines.begin(); next != lines.end();) {
      const Knife::Line line = next->second.back();
      next->second.pop_back();
      if (next->second.empty()) lines.erase(next);
      loop.push_back({knife.at(line.from), knife.at(line.to), 0, line.patch});
      next = lines.find(line.to);
    }
    // From where the patch changes, so that one straight wall begins there.
    for (std::size_t k = 1; k < loop.size(); ++k)
      if (loop[k].patch != loop[k - 1].patch) {
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(k), loop.end());
        break;
      }
    straighten(loop, tolerance);
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

Section slice(const MeshTank& tank, const SectionPlane& plane) {
  check_met(tank.bounds(), plane);
  const Knife knife(tank.wall().mesh(), plane);
  return section_of(loops_in(knife, straightness * tank.bounds().size().norm()), tank.patches());
}

}  // namespace seiche::solver
