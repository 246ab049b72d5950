#include "solver/modes/joined_holes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

/// Whether c, on the line through a and b, or near it, lies on the way from a to b.
bool is_on(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) { return turn(a, b, c) == 0 && (c - a).dot(c - b) <= 0; }

/// Whether the cut from a to b meets the edge from c to d elsewhere than at its own ends.
bool meets(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c, const Vec<2>& d) {
  const bool c_is_end = c == a || c == b, d_is_end = d == a || d == b;
  if ((!c_is_end && is_on(a, b, c)) || (!d_is_end && is_on(a, b, d))) return true;
  if (c_is_end || d_is_end) return false;
  if (is_on(c, d, a) || is_on(c, d, b)) return true;
  return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

struct Joiner {
  Walk walk;
  std::vector<std::vector<int>> holes = {};

  const Vec<2>& at(int k) const { return walk.corners[static_cast<std::size_t>(k)].at; }

  /// Whether the way from corner k of a loop to a point begins in the liquid.
  bool looks_at(const std::vector<int>& loop, std::size_t k, const Vec<2>& to) const {
    const Vec<2>&before = at(loop[(k + loop.size() - 1) % loop.size()]), &here = at(loop[k]),
          &after = at(loop[(k + 1) % loop.size()]);
    const bool left_of_last = turn(before, here, to) > 0, left_of_next = turn(here, after, to) > 0;
    const double bend = turn(before, here, after);
    const bool turns_back = bend == 0 && (before - here).dot(after - here) > 0;
    if (bend < 0) return left_of_last || left_of_next;
    return turns_back ? turn(here, after, to) != 0 || (to - here).dot(after - here) < 0 : left_of_last && left_of_next;
  }

  bool is_free(const Vec<2>& a, const Vec<2>& b, const std::vector<int>& loop) const {
    for (std::size_t k = 0; k < loop.size(); ++k)
      if (meets(a, b, at(loop[k]), at(loop[(k + 1) % loop.size()]))) return false;
    return true;
  }

  bool is_free(const Vec<2>& a, const Vec<2>& b) const {
    return is_free(a, b, walk.order) &&
           std::all_of(holes.begin(), holes.end(), [&](const auto& hole) { return is_free(a, b, hole); });
  }

  /// By the shortest free cut; false if there is none.
  bool join(const std::vector<int>& hole) {
    double shortest = std::numeric_limits<double>::infinity();
    std::size_t from = 0, to = 0;
    for (std::size_t k = 0; k < walk.order.size(); ++k)
      for (std::size_t m = 0; m < hole.size(); ++m) {
        const Vec<2>&a = at(walk.order[k]), &b = at(hole[m]);
        const double squared = (b - a).squaredNorm();
        if (squared == 0 || squared >= shortest || !looks_at(walk.order, k, b) || !looks_at(hole, m, a) ||
            !is_free(a, b))
          continue;
        shortest = squared;
        from = k;
        to = m;
      }
    if (shortest == std::numeric_limits<double>::infinity()) return false;
    std::vector<int> detour;
    for (std::size_t m = 0; m <= hole.size(); ++m) detour.push_back(hole[(to + m) % hole.size()]);
    detour.push_back(walk.order[from]);
    walk.order.insert(walk.order.begin() + static_cast<std::ptrdiff_t>(from) + 1, detour.begin(), detour.end());
    return true;
  }
};

}  // namespace

Walk joined(const Outline& outline) {
  Joiner joiner{{}};
  const auto numbered = [&](const Loop& loop) {
    std::vector<int> order;
    for (const Corner& corner : loop) {
      order.push_back(static_cast<int>(joiner.walk.corners.size()));
      joiner.walk.corners.push_back(corner);
    }
    return order;
  };
  joiner.walk.order = numbered(outline.outer);
  for (const Loop& hole : outline.holes) joiner.holes.push_back(numbered(hole));
  while (!joiner.holes.empty()) {
    const auto joined = std::find_if(joiner.holes.begin(), joiner.holes.end(),
                                     [&](const std::vector<int>& hole) { return joiner.join(hole); });
    if (joined == joiner.holes.end()) {
      const Vec<2> place = outline.place(joiner.at(joiner.holes[0][0]));
      throw BadParameters(fmt::format(
          "first frequencies: the section's loop at ({:.6g}, {:.6g}) m crosses or touches another; keep them apart",
          place[0], place[1]));
    }
    joiner.holes.erase(joined);
  }
  return joiner.walk;
}

}  // namespace seiche::solver::modes
