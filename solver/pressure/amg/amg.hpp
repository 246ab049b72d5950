#pragma once
#include "solver/pressure/amg/galerkin.hpp"
#include "solver/pressure/amg/skyline.hpp"

namespace seiche::solver {

/// Multigrid by plain aggregation, as a preconditioner B ~ A^-1 of flexible conjugate gradients. Every level smooths by
/// one Gauss-Seidel sweep up before and one down after the correction from the next; the first correction is solved for
/// by a K-cycle, that is up to two steps of flexible conjugate gradients on each level, preconditioned by the levels
/// below it (Notay & Vassilevski 2008; Notay 2010), which keeps the iterations from growing with the tank. B depends a
/// little on what it is applied to. Buffers are kept from one matrix to the next.
class Amg {
 public:
  struct Level {
    AmgMatrix matrix;
    Aggregates aggregates;       ///< that make the next level; the last has none
    std::vector<double> smooth;  ///< x between the two sweeps
    std::vector<double> right, solution, residual, step1, image1, step2, image2;  ///< of the K-cycle
  };

  void set_up(const SparseView& a);
  /// z = B r
  void apply(const double* r, double* z) { cycle(0, r, z); }

  int levels() const { return levels_; }
  const Level& level(int l) const { return level_[l]; }

 private:
  void cycle(int l, const double* b, double* x);
  void solve(int l);

  int levels_ = 0;
  std::vector<Level> level_;
  Galerkin galerkin_;
  Skyline skyline_;
  ChunkSums sums_;
};

}  // namespace seiche::solver
