#pragma once

namespace seiche::solver {

/// sum_k a_k x[j_k] over entries first to last - 1 of a sparse matrix. In two sums: an addition need not wait for the
/// one before.
template <class T>
double row_times(const T* a, const int* j, int first, int last, const double* x) {
  double even = 0, odd = 0;
  int k = first;
  for (; k + 1 < last; k += 2) {
    even += a[k] * x[j[k]];
    odd += a[k + 1] * x[j[k + 1]];
  }
  if (k < last) even += a[k] * x[j[k]];
  return even + odd;
}

}  // namespace seiche::solver
