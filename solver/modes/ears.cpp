#include "solver/modes/ears.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

bool holds(const std::array<Vec<2>, 3>& triangle, const Vec<2>& r) {
  if (r == triangle[0] || r == triangle[1] || r == triangle[2]) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (turn(triangle[k], triangle[(k + 1) % 3], r) < 0) return false;
  return true;
}

}  // namespace

std::vector<std::array<int, 3>> ears(const Walk& walk, const Outline& outline) {
  std::vector<int> left = walk.order;
  const auto at = [&](int k) -> const Vec<2>& { return walk.corners[static_cast<std::size_t>(k)].at; };
  std::vector<std::array<int, 3>> triangles;
  std::size_t tried = 0, k = 0;
  while (left.size() > 2) {
    if (tried == left.size()) {
      const Vec<2> place = outline.place(at(left[0]));
      throw BadParameters(fmt::format(
          "first frequencies: the section crosses itself near ({:.6g}, {:.6g}) m; draw its loops without crossings",
          place[0], place[1]));
    }
    const std::size_t count = left.size();
    k %= count;
    const std::array<int, 3> ear{left[(k + count - 1) % count], left[k], left[(k + 1) % count]};
    const std::array<Vec<2>, 3> corners{at(ear[0]), at(ear[1]), at(ear[2])};
    if (turn(corners[0], corners[1], corners[2]) > 0 &&
        std::none_of(left.begin(), left.end(), [&](int other) { return holds(corners, at(other)); })) {
      triangles.push_back(ear);
      left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
      tried = 0;
    } else {
      ++tried;
    }
    ++k;  // past the neighbour, so that the triangles don't all meet in one corner
  }
  return triangles;
}

}  // namespace seiche::solver::modes
