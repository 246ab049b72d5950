#include "solver/pressure/amg/amg_matrix.hpp"

#include "solver/particles/kept.hpp"

namespace seiche::solver {

void AmgMatrix::keep_strong(const SparseView& a) {
  constexpr double weak = 0.1;
  const int *start = a.outerIndexPtr(), *index = a.innerIndexPtr();
  const double* value = a.valuePtr();
  rows = static_cast<int>(a.rows());
  resize_kept(row, rows);
  resize_kept(column, a.nonZeros());
  resize_kept(weight, a.nonZeros());
  resize_kept(sum, rows);
  resize_kept(diagonal, rows);
  resize_kept(inverse, rows);
  resize_kept(least_, rows);
  each_row(rows, [&](int i) {
    double total = 0, strongest = 0;
    for (int k = start[i]; k < start[i + 1]; ++k) {
      total += value[k];
      strongest = std::max(strongest, -value[k]);
    }
    sum[i] = total;
    least_[i] = weak * strongest;
  });
  each_chunk(rows, [&](int first, int last) {
    int out = start[first];
    for (int i = first; i < last; ++i) {
      const auto keep = [&](int begin, int end) {
        for (int k = begin; k < end; ++k) {  // without a branch, which would be a guess
          const int j = index[k];
          column[out] = j;
          weight[out] = static_cast<float>(-value[k]);
          out += value[k] < 0 && -value[k] >= std::min(least_[i], least_[j]);
        }
      };
      int below = start[i], own, after = start[i + 1];
      while (below < after && index[below] < first) ++below;
      while (after > below && index[after - 1] >= last) --after;
      for (own = below; own < after && index[own] < i;) ++own;
      const int above = own < after && index[own] == i ? own + 1 : own;
      row[i].lower = out;
      keep(below, own);
      row[i].outside = out;
      keep(start[i], below);
      keep(after, start[i + 1]);
      row[i].upper = out;
      keep(above, after);
      row[i].end = out;
      close_row(i);
    }
  });
}

void AmgMatrix::close_row(int i) {
  double total = sum[i];
  for (int k = row[i].lower; k < row[i].end; ++k) total += weight[k];
  diagonal[i] = total;
  inverse[i] = total > 0 ? 1 / total : 0;  // an empty row of a singular system: its x stays 0
}

void AmgMatrix::sweep_up(const double* b, double* x) const {
  each_row(rows, [&](int i) { x[i] = (b[i] + linked(row[i].lower, row[i].outside, x)) * inverse[i]; });
}

void AmgMatrix::sweep_down(const double* b, const double* from, double* x) const {
  each_chunk(rows, [&](int first, int last) {
    for (int i = last - 1; i >= first; --i) {
      double swept = 0;  // last comes the nearest row, which has only just been found
      for (int k = row[i].end - 1; k >= row[i].upper; --k) swept += weight[k] * x[column[k]];
      x[i] = (b[i] + linked(row[i].lower, row[i].upper, from) + swept) * inverse[i];
    }
  });
}

}  // namespace seiche::solver
