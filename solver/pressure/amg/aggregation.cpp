#include "solver/pressure/amg/aggregation.hpp"

#include "solver/particles/kept.hpp"

namespace seiche::solver {
namespace {

constexpr int none = -1, undecided = -2;

/// Calls f(j) for each row j that row i is strongly linked to.
template <class F>
void each_strong(const AmgMatrix& a, int i, F f) {
  const auto [first, last] = std::pair(a.row[i].lower, a.row[i].end);
  float strongest = 0;
  for (int k = first; k < last; ++k) strongest = std::max(strongest, a.weight[k]);
  for (int k = first; k < last; ++k)
    if (a.weight[k] >= 0.25f * strongest) f(a.column[k]);
}

}  // namespace

void Aggregates::find(const AmgMatrix& a) {
  count = 0;
  assign_kept(of, a.rows, undecided);
  form(a);
  join(a);
  list_members(a.rows);
}

void Aggregates::form(const AmgMatrix& a) {
  constexpr int enough = 3;  // 4 takes one or two iterations more, 5 fails on a perfect lattice: 65 instead of 10
  for (int i = 0; i < a.rows; ++i) {
    if (of[i] != undecided) continue;
    if (a.row[i].lower == a.row[i].end) of[i] = none;
    int free = 0;
    each_strong(a, i, [&](int j) { free += of[j] == undecided; });
    if (free < enough) continue;
    of[i] = count;
    each_strong(a, i, [&](int j) {
      if (of[j] == undecided) of[j] = count;
    });
    ++count;
  }
}

void Aggregates::join(const AmgMatrix& a) {
  for (int i = 0; i < a.rows; ++i) {
    if (of[i] != undecided) continue;
    float strongest = 0;
    for (int k = a.row[i].lower; k < a.row[i].end; ++k)
      if (of[a.column[k]] >= 0 && a.weight[k] > strongest) {
        strongest = a.weight[k];
        of[i] = of[a.column[k]];
      }
    if (of[i] >= 0) continue;
    of[i] = count;
    each_strong(a, i, [&](int j) { of[j] = count; });
    ++count;
  }
}

void Aggregates::list_members(int rows) {
  assign_kept(start, count + 1, 0);
  for (int i = 0; i < rows; ++i)
    if (of[i] >= 0) ++start[of[i]];
  for (int g = 0, total = 0; g <= count; ++g) start[g] = total += start[g];
  resize_kept(member, start[count]);
  for (int i = rows - 1; i >= 0; --i)
    if (of[i] >= 0) member[--start[of[i]]] = i;
}

}  // namespace seiche::solver
