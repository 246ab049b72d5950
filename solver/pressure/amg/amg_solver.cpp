#include "solver/pressure/amg/amg_solver.hpp"

#include <cmath>

#include "solver/particles/kept.hpp"

namespace seiche::solver {
namespace {

/// (A x)_i
double product(const SparseView& a, int i, const double* x) {
  const int* start = a.outerIndexPtr();
  return row_times(a.valuePtr(), a.innerIndexPtr(), start[i], start[i + 1], x);
}

}  // namespace

SolveReport AmgSolver::solve(const SparseView& a, const VectorIn& b, VectorOut x) {
  const int rows = static_cast<int>(a.rows());
  for (auto* v : {&residual_, &corrected_, &direction_, &image_}) resize_kept(*v, rows);
  double *r = residual_.data(), *z = corrected_.data(), *p = direction_.data(), *q = image_.data();

  const auto [bb, first] = sums_.add_up<2>(rows, [&](int i, auto& s) {
    r[i] = b[i] - product(a, i, x.data());
    s[0] += b[i] * b[i];
    s[1] += r[i] * r[i];
  });
  if (bb == 0) {
    x.setZero();
    return {0, 0, true};
  }
  SolveReport report{0, std::sqrt(first / bb), false};
  if (!(report.residual <= tolerance_)) amg_.set_up(a);
  double pAp = 1;
  while (!(report.residual <= tolerance_) && std::isfinite(report.residual) && report.iterations < max_iterations_) {
    amg_.apply(r, z);
    if (report.iterations == 0) {
      std::fill_n(p, rows, 0.0);
      std::fill_n(q, rows, 0.0);
    }
    // beta = z.(r - r_old) / z_old.r_old, in which r - r_old = -alpha q and alpha = z_old.r_old / p.q.
    const auto [zr, zq] = sums_.add_up<2>(rows, [&](int i, auto& s) {
      s[0] += z[i] * r[i];
      s[1] += z[i] * q[i];
    });
    const double beta = -zq / pAp;
    each_row(rows, [&](int i) { p[i] = z[i] + beta * p[i]; });
    pAp = sums_.add_up<1>(rows, [&](int i, auto& s) {
      q[i] = product(a, i, p);
      s[0] += p[i] * q[i];
    })[0];
    const double alpha = zr / pAp;
    const auto [rr] = sums_.add_up<1>(rows, [&](int i, auto& s) {
      x[i] += alpha * p[i];
      r[i] -= alpha * q[i];
      s[0] += r[i] * r[i];
    });
    ++report.iterations;
    report.residual = std::sqrt(rr / bb);
  }
  report.converged = report.residual <= tolerance_;
  return report;
}

}  // namespace seiche::solver
