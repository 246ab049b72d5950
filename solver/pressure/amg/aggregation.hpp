#pragma once
#include "solver/pressure/amg/amg_matrix.hpp"

namespace seiche::solver {

/// Rows gathered into aggregates, which are the unknowns of the next level: prolongation is constant on each.
struct Aggregates {
  int count = 0;
  std::vector<int> of;     ///< aggregate of each row; -1: none, for a row without links
  std::vector<int> start;  ///< aggregate g holds rows member[start[g]] .. member[start[g + 1] - 1], rising
  std::vector<int> member;

  /// Greedy, in the order of the rows (after Vanek, Mandel, Brezina 1996): a row founds an aggregate with those
  /// strongly linked rows that have none yet, where there are enough of them; a row left over joins the aggregate that
  /// it is most strongly linked to. 4 to 5 rows an aggregate in 2-D, 8 in 3-D; 2 at least. Runs on one thread:
  /// aggregates that end at the borders of chunks take up to four times the iterations.
  void find(const AmgMatrix& a);

  template <class F>
  void each_member(int g, F f) const {
    for (int m = start[g]; m < start[g + 1]; ++m) f(member[m]);
  }

 private:
  void form(const AmgMatrix& a);
  void join(const AmgMatrix& a);
  void list_members(int rows);
};

}  // namespace seiche::solver
