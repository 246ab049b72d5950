#pragma once
#include "solver/particles/chunks.hpp"
#include "solver/pressure/amg/sparse_row.hpp"
#include "solver/pressure/sparse_matrix.hpp"

namespace seiche::solver {

/// The matrix of one level of the multigrid preconditioner, as a graph of links:
/// (A x)_i = sum_j w_ij (x_i - x_j) + s_i x_i, w_ij = -a_ij >= 0, s_i the sum of row i. The sums are kept apart from
/// the weights, which may then be floats (half the memory to read) without a nearly singular A losing what makes it
/// regular.
///
/// Smoothing is Gauss-Seidel within a chunk of rows and Jacobi between chunks (see chunks.hpp). For that each row has
/// its links in three parts: to lower rows of its chunk, to other chunks, to higher rows of its chunk.
struct AmgMatrix {
  struct Row {
    int lower, outside, upper, end;  ///< where its links to each begin
  };

  int rows = 0;
  std::vector<Row> row;
  std::vector<int> column;       ///< j of each link; what no row refers to is unused
  std::vector<float> weight;     ///< w_ij
  std::vector<double> sum;       ///< s_i
  std::vector<double> diagonal;  ///< a_ii = s_i + sum_j w_ij
  std::vector<double> inverse;   ///< 1/a_ii

  /// A without its weak links, those of less than a tenth of the strongest of both their rows. At r_e = 2.6 l0 that is
  /// half of all in 2-D and two thirds in 3-D; as a preconditioner the rest is as good (as many iterations).
  void keep_strong(const SparseView& a);

  /// Sets the diagonal of row i from its links and sum.
  void close_row(int i);

  double linked(int first, int last, const double* x) const {
    return row_times(weight.data(), column.data(), first, last, x);
  }

  /// (A x)_i
  double product(int i, const double* x) const { return diagonal[i] * x[i] - linked(row[i].lower, row[i].end, x); }

  /// x from one sweep through rising rows that starts at x = 0.
  void sweep_up(const double* b, double* x) const;
  /// (b - A x)_i just after sweep_up(b, x), which left only the links that it hadn't used.
  double residual_after_sweep_up(int i, const double* x) const { return linked(row[i].outside, row[i].end, x); }
  /// x from one sweep through falling rows that starts at `from`: the adjoint of sweep_up.
  void sweep_down(const double* b, const double* from, double* x) const;

 private:
  std::vector<double> least_;
};

}  // namespace seiche::solver
