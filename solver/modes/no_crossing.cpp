#include "solver/modes/no_crossing.hpp"

#include <fmt/format.h>

#include "solver/errors.hpp"

namespace seiche::solver::modes {
namespace {

struct Side {
  Vec<2> from, to, low, high;
};

void add(const Loop& loop, std::vector<Side>& sides) {
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec<2>&from = loop[k].at, &to = loop[(k + 1) % loop.size()].at;
    sides.push_back({from, to, from.cwiseMin(to), from.cwiseMax(to)});
  }
}

bool cross_each_other(const Side& a, const Side& b) {
  if ((a.high.array() < b.low.array()).any() || (b.high.array() < a.low.array()).any()) return false;
  return turn(a.from, a.to, b.from) * turn(a.from, a.to, b.to) < 0 &&
         turn(b.from, b.to, a.from) * turn(b.from, b.to, a.to) < 0;
}

}  // namespace

void check_no_crossing(const Outline& outline) {
  std::vector<Side> sides;
  add(outline.outer, sides);
  for (const Loop& hole : outline.holes) add(hole, sides);
  for (std::size_t k = 0; k < sides.size(); ++k)
    for (std::size_t m = k + 1; m < sides.size(); ++m)
      if (cross_each_other(sides[k], sides[m])) {
        const Vec<2> place = outline.place(0.5 * (sides[k].from + sides[k].to));
        throw BadParameters(fmt::format(
            "first frequencies: the section's wall crosses itself near ({:.6g}, {:.6g}) m; draw its loops without "
            "crossings",
            place[0], place[1]));
      }
}

}  // namespace seiche::solver::modes
