#include "solver/pressure/amg/amg.hpp"

#include "solver/particles/kept.hpp"

namespace seiche::solver {

void Amg::set_up(const SparseView& a) {
  constexpr int few = 200;  // rows for the skyline: more take longer to factorise than to coarsen
  levels_ = 0;
  if (level_.empty()) level_.resize(32);  // each level has half of the rows before it at most
  level_[0].matrix.keep_strong(a);
  for (;;) {
    Level& fine = level_[levels_++];
    const int rows = fine.matrix.rows;
    resize_kept(fine.smooth, rows);
    if (levels_ > 1) {
      for (auto* v :
           {&fine.right, &fine.solution, &fine.residual, &fine.step1, &fine.image1, &fine.step2, &fine.image2})
        resize_kept(*v, rows);
      if (rows <= few) break;
    }
    fine.aggregates.find(fine.matrix);
    if (fine.aggregates.count == 0) break;
    galerkin_.form(fine.matrix, fine.aggregates, level_[levels_].matrix);
  }
  skyline_.factorise(level_[levels_ - 1].matrix);
}

/// x ~ A^-1 b on a level: sweep up, correction from the next level, sweep down.
void Amg::cycle(int l, const double* b, double* x) {
  Level& fine = level_[l];
  const AmgMatrix& a = fine.matrix;
  double* smooth = fine.smooth.data();
  a.sweep_up(b, smooth);
  if (l + 1 < levels_) {
    // Piecewise constant corrections fall short (Braess 1995); this much saves one iteration of twelve.
    constexpr double over = 1.3;
    Level& coarse = level_[l + 1];
    const Aggregates& p = fine.aggregates;
    each_row(coarse.matrix.rows, [&](int g) {
      double total = 0;
      p.each_member(g, [&](int i) { total += a.residual_after_sweep_up(i, smooth); });
      coarse.right[g] = total;
    });
    solve(l + 1);
    each_row(a.rows, [&](int i) {
      if (p.of[i] >= 0) smooth[i] += over * coarse.solution[p.of[i]];
    });
  }
  a.sweep_down(b, smooth, x);
}

/// The K-cycle: solution ~ A^-1 right on a level, exact on the last.
void Amg::solve(int l) {
  Level& f = level_[l];
  if (l + 1 == levels_) return skyline_.solve(f.right.data(), f.solution.data());
  const int rows = f.matrix.rows;
  const auto scaled = [&](double t1, double t2) {
    each_row(rows, [&](int i) { f.solution[i] = t1 * f.step1[i] + (t2 != 0 ? t2 * f.step2[i] : 0); });
  };
  cycle(l, f.right.data(), f.step1.data());
  const auto [pAp, pb, bb] = sums_.add_up<3>(rows, [&](int i, auto& s) {
    f.image1[i] = f.matrix.product(i, f.step1.data());
    s[0] += f.step1[i] * f.image1[i];
    s[1] += f.step1[i] * f.right[i];
    s[2] += f.right[i] * f.right[i];
  });
  if (!(pAp > 0)) return scaled(1, 0);
  const double t = pb / pAp;
  const auto [rr] = sums_.add_up<1>(rows, [&](int i, auto& s) {
    f.residual[i] = f.right[i] - t * f.image1[i];
    s[0] += f.residual[i] * f.residual[i];
  });
  constexpr double enough = 0.25;
  if (rr <= enough * enough * bb) return scaled(t, 0);
  cycle(l, f.residual.data(), f.step2.data());
  const auto [qAp, qAq, qr] = sums_.add_up<3>(rows, [&](int i, auto& s) {
    f.image2[i] = f.matrix.product(i, f.step2.data());
    s[0] += f.step2[i] * f.image1[i];
    s[1] += f.step2[i] * f.image2[i];
    s[2] += f.step2[i] * f.residual[i];
  });
  const double conjugate = qAq - qAp * qAp / pAp;
  if (!(conjugate > 0)) return scaled(t, 0);
  scaled(t - qAp * qr / (pAp * conjugate), qr / conjugate);
}

}  // namespace seiche::solver
