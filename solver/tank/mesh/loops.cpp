#include "solver/tank/mesh/loops.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "solver/tank/mesh/edges.hpp"

namespace seiche::solver {
namespace {

/// Splits a way that comes back to its beginning at the points that it meets more than once.
void add_simple_loops(const std::vector<int>& way, std::vector<HoleLoop>& loops) {
  HoleLoop open;
  for (const int point : way) {
    const auto before = std::find(open.begin(), open.end(), point);
    if (before != open.end()) {
      loops.emplace_back(before, open.end());
      open.erase(before, open.end());
    }
    open.push_back(point);
  }
  loops.push_back(std::move(open));
}

}  // namespace

std::vector<HoleLoop> loops_of(const Triangles& mesh) {
  // From the end of each open side to its beginning: the triangle beyond it would have it so.
  std::multimap<int, int> ways;
  for (const MeshEdge& edge : edges_of(mesh))
    if (edge.sides.size() == 1) ways.emplace(end_of(mesh, edge.sides[0]), begin_of(mesh, edge.sides[0]));
  std::vector<HoleLoop> loops;
  while (!ways.empty()) {
    std::vector<int> way;
    for (auto step = ways.begin(); step != ways.end(); step = ways.find(way.back())) {
      if (way.empty()) way.push_back(step->first);
      way.push_back(step->second);
      ways.erase(step);
    }
    // It ends where it began, unless more than two triangles meet at a side.
    if (way.front() == way.back()) way.pop_back();
    add_simple_loops(way, loops);
  }
  std::erase_if(loops, [](const HoleLoop& loop) { return loop.size() < 3; });
  return loops;
}

std::vector<std::array<int, 3>> ears_of(const Triangles& mesh, const HoleLoop& loop) {
  const int count = static_cast<int>(loop.size());
  std::vector<int> before(count), after(count);
  const auto new_side = [&](int k) { return (mesh.points[loop[before[k]]] - mesh.points[loop[after[k]]]).norm(); };
  std::set<std::pair<double, int>> ears;
  for (int k = 0; k < count; ++k) {
    before[k] = (k + count - 1) % count;
    after[k] = (k + 1) % count;
  }
  for (int k = 0; k < count; ++k) ears.emplace(new_side(k), k);
  std::vector<std::array<int, 3>> cut;
  while (ears.size() > 2) {
    const int k = ears.begin()->second, a = before[k], b = after[k];
    cut.push_back({a, k, b});
    for (const int changed : {a, k, b}) ears.erase({new_side(changed), changed});
    after[a] = b;
    before[b] = a;
    for (const int changed : {a, b}) ears.emplace(new_side(changed), changed);
  }
  return cut;
}

}  // namespace seiche::solver
