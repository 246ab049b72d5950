#pragma once
#include <vector>

#include "solver/particles/kept.hpp"
#include "solver/pressure/boundary.hpp"
#include "solver/pressure/sparse_matrix.hpp"

namespace seiche::solver {

/// Added to the diagonal of the pressure equation, in units of n0: keeps the matrix definite where a clump of particles
/// touches no free surface, and is far below the discretisation error everywhere else.
inline constexpr double definite = 1e-7;

/// The pressure equation (10) as A p = b, A sparse, symmetric, positive definite. Both sides of equation (10) are
/// multiplied by -lambda n0/(2d), so that row i reads  sum_j w_ij (p_i - p_j) + c p_i = b_i.
template <int D>
class PressureSystem {
 public:
  /// @param diagonal c >= 0, the same in every row
  template <class Boundary>
  void assemble(const Pairs<D>& pairs, double diagonal, const Boundary& boundary, const State<D>& s) {
    const int size = static_cast<int>(s.size());
    assign_kept(row_, size, -1);
    particle_.clear();
    for (int i = 0; i < size; ++i)
      if (boundary.unknown(i)) {
        row_[i] = static_cast<int>(particle_.size());
        particle_.push_back(i);
      }
    const int rows = static_cast<int>(particle_.size());
    assign_kept(start_, rows + 1, 0);
#pragma omp parallel for schedule(static)
    for (int k = 0; k < rows; ++k) {
      int count = 1;
      for (int j : pairs[particle_[k]]) count += row_[j] >= 0;
      start_[k + 1] = count;
    }
    for (int k = 0; k < rows; ++k) start_[k + 1] += start_[k];
    resize_kept(column_, start_[rows]);
    resize_kept(value_, start_[rows]);
    resize_kept(rhs_, rows);
#pragma omp parallel for schedule(static)
    for (int k = 0; k < rows; ++k) fill_row(pairs, diagonal, boundary, s, k);
  }

  int rows() const { return static_cast<int>(particle_.size()); }
  SparseView matrix() const {
    return {rows(), rows(), static_cast<int>(value_.size()), start_.data(), column_.data(), value_.data()};
  }
  /// b; holds what the boundary adds after assemble(), to which the caller adds the source.
  VectorView rhs() { return {rhs_.data(), rows()}; }
  /// Particle of a row, and row of a particle (-1: it has none).
  int particle(int row) const { return particle_[row]; }
  int row(int particle) const { return row_[particle]; }

 private:
  template <class Boundary>
  void fill_row(const Pairs<D>& pairs, double diagonal, const Boundary& boundary, const State<D>& s, int k) {
    const int i = particle_[k];
    int out = start_[k], place = -1;
    double sum = diagonal + boundary.diagonal(i), rhs = 0;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      if (place < 0 && j > i) place = out++;
      weight *= s.wet[j] * rij.squaredNorm();
      if (row_[j] < 0) {
        sum += boundary.pair_diagonal(j, weight);
        rhs += boundary.pair_rhs(i, j, weight, rij);
      } else {
        sum += weight;
        column_[out] = row_[j];
        value_[out++] = -weight;
      }
    });
    if (place < 0) place = out;
    column_[place] = k;
    value_[place] = sum;
    rhs_[k] = rhs;
  }

  std::vector<int> row_, particle_, start_, column_;
  Scalars value_, rhs_;
};

}  // namespace seiche::solver
