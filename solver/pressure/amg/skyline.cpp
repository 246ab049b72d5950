#include "solver/pressure/amg/skyline.hpp"

#include <cmath>

#include "solver/particles/kept.hpp"

namespace seiche::solver {
namespace {

double dot(const double* a, const double* b, int first, int last) {
  double even = 0, odd = 0;
  int k = first;
  for (; k + 1 < last; k += 2) {
    even += a[k] * b[k];
    odd += a[k + 1] * b[k + 1];
  }
  return k < last ? even + odd + a[k] * b[k] : even + odd;
}

}  // namespace

void Skyline::factorise(const AmgMatrix& a) {
  rows_ = a.rows;
  resize_kept(first_, rows_);
  resize_kept(start_, rows_);
  resize_kept(inverse_, rows_);
  resize_kept(work_, rows_);
  int size = 0;
  for (int i = 0; i < rows_; ++i) {
    first_[i] = i;
    for (int k = a.row[i].lower; k < a.row[i].end; ++k) first_[i] = std::min(first_[i], a.column[k]);
    start_[i] = size;
    size += i - first_[i] + 1;
  }
  assign_kept(value_, size, 0.0);
  // Each link adds to both its diagonals here, so that a last bit of difference between w_ij and w_ji cannot make a
  // nearly singular matrix indefinite.
  for (int i = 0; i < rows_; ++i) {
    row(i)[i] += a.sum[i];
    for (int k = a.row[i].lower; k < a.row[i].end; ++k) {
      const int j = a.column[k];
      if (j > i) continue;
      row(i)[j] -= a.weight[k];
      row(i)[i] += a.weight[k];
      row(j)[j] += a.weight[k];
    }
  }
  for (int i = 0; i < rows_; ++i) {
    double* li = row(i);
    const double before = li[i];
    for (int j = first_[i]; j < i; ++j) {
      li[j] = (li[j] - dot(li, row(j), std::max(first_[i], first_[j]), j)) * inverse_[j];
    }
    const double pivot = before - dot(li, li, first_[i], i);
    inverse_[i] = pivot > 1e-13 * before ? 1 / std::sqrt(pivot) : 0;
  }
}

void Skyline::solve(const double* b, double* x) {
  for (int i = 0; i < rows_; ++i) work_[i] = (b[i] - dot(row(i), work_.data(), first_[i], i)) * inverse_[i];
  for (int i = rows_ - 1; i >= 0; --i) {
    x[i] = work_[i] * inverse_[i];
    for (int k = first_[i]; k < i; ++k) work_[k] -= row(i)[k] * x[i];
  }
}

}  // namespace seiche::solver
