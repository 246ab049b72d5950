#include "solver/modes/level_cut.hpp"

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

using Points = std::vector<Vec<2>>;

/// Where a chain of wall below the level begins (comes down) or ends (goes up).
struct Crossing {
  double x;
  std::size_t chain;
  bool down;
};

Vec<2> crossing(const Vec<2>& a, const Vec<2>& b, double level) {
  return {std::round(a[0] + (level - a[1]) / (b[1] - a[1]) * (b[0] - a[0])), level};
}

/// The pieces of a polygon below the level, with their ends on it; `loops` get the polygon that is all below.
void cut(const Points& polygon, double level, std::vector<Points>& chains, std::vector<Loop>& loops) {
  const std::size_t count = polygon.size();
  const auto below = [&](std::size_t k) { return polygon[k % count][1] < level; };
  std::size_t first = 0;
  while (first < count && (below(first) || !below(first + 1))) ++first;
  if (first == count) {
    if (count < 2 || !below(0)) return;
    Loop& loop = loops.emplace_back();
    for (const Vec<2>& at : polygon) loop.push_back({at, false});
    return;
  }
  for (std::size_t k = first; k < first + count; ++k) {
    const Vec<2>&a = polygon[k % count], &b = polygon[(k + 1) % count];
    if (!below(k) && below(k + 1)) chains.push_back({crossing(a, b, level)});
    if (below(k + 1)) chains.back().push_back(b);
    if (below(k) && !below(k + 1)) chains.back().push_back(crossing(a, b, level));
  }
}

/// The chain that follows each across a piece of free surface, from right to left.
std::vector<std::size_t> followers(const std::vector<Points>& chains) {
  std::vector<Crossing> all;
  for (std::size_t k = 0; k < chains.size(); ++k) {
    all.push_back({chains[k].front()[0], k, true});
    all.push_back({chains[k].back()[0], k, false});
  }
  std::sort(all.begin(), all.end(), [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  std::vector<std::size_t> next(chains.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    const bool down = k % 2 == 0;
    std::size_t other = k;
    while (other < all.size() && all[other].x == all[k].x && all[other].down != down) ++other;
    if (other == all.size() || all[other].down != down)
      throw BadParameters(
          "first frequencies: the section crosses itself at the level; draw its loops without crossings");
    std::swap(all[k], all[other]);
    if (!down) next[all[k].chain] = all[k - 1].chain;
  }
  return next;
}

}  // namespace

std::vector<Loop> loops_below(double level, const std::vector<Points>& polygons) {
  std::vector<Loop> loops;
  std::vector<Points> chains;
  for (const Points& polygon : polygons) cut(polygon, level, chains, loops);
  const std::vector<std::size_t> next = followers(chains);
  std::vector<bool> used(chains.size(), false);
  for (std::size_t first = 0; first < chains.size(); ++first) {
    if (used[first]) continue;
    Loop loop;
    for (std::size_t k = first; !used[k]; k = next[k]) {
      used[k] = true;
      for (const Vec<2>& at : chains[k]) loop.push_back({at, false});
      loop.back().surface = true;
      // Where the wall touches the level from below, the piece of surface has no length.
      if (chains[k].back() == chains[next[k]].front()) loop.pop_back();
    }
    if (loop.size() > 1) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace seiche::solver::modes
