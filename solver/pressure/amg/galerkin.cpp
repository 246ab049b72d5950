#include "solver/pressure/amg/galerkin.hpp"

#include <omp.h>

#include "solver/particles/kept.hpp"

namespace seiche::solver {

void Galerkin::form(const AmgMatrix& a, const Aggregates& p, AmgMatrix& coarse) {
  const int rows = coarse.rows = p.count;
  resize_kept(coarse.row, rows);
  resize_kept(coarse.sum, rows);
  resize_kept(coarse.diagonal, rows);
  resize_kept(coarse.inverse, rows);

  // A chunk of coarse rows gets room for as many links as its members have.
  assign_kept(room_, chunks_of(rows) + 1, 0);
  each_chunk(rows, [&](int first, int last) {
    for (int m = p.start[first]; m < p.start[last]; ++m)
      room_[first / chunk_rows + 1] += a.row[p.member[m]].end - a.row[p.member[m]].lower;
  });
  for (int c = 0; c < chunks_of(rows); ++c) room_[c + 1] += room_[c];
  resize_kept(coarse.column, room_.back());
  resize_kept(coarse.weight, room_.back());

  gathered_.resize(std::max<std::size_t>(gathered_.size(), omp_get_max_threads()));
  for (Gathered& g : gathered_) {
    reserve_kept(g.place, rows);
    g.place.resize(std::max<std::size_t>(g.place.size(), rows), -1);
    reserve_kept(g.column, rows);  // no row links to more
    reserve_kept(g.weight, rows);
  }
  each_chunk(rows, [&](int first, int last) {
    Gathered& found = gathered_[omp_get_thread_num()];
    int out = room_[first / chunk_rows];
    for (int g = first; g < last; ++g) {
      found.column.clear();
      found.weight.clear();
      double sum = 0;
      p.each_member(g, [&](int i) {
        sum += a.sum[i];
        for (int k = a.row[i].lower; k < a.row[i].end; ++k) {
          const int h = p.of[a.column[k]];
          if (h == g || h < 0) continue;
          if (found.place[h] < 0) {
            found.place[h] = static_cast<int>(found.column.size());
            found.column.push_back(h);
            found.weight.push_back(a.weight[k]);
          } else {
            found.weight[found.place[h]] += a.weight[k];
          }
        }
      });
      const auto put = [&](auto belongs) {
        const int begin = out;
        for (std::size_t n = 0; n < found.column.size(); ++n)
          if (belongs(found.column[n])) {
            coarse.column[out] = found.column[n];
            coarse.weight[out++] = found.weight[n];
          }
        return begin;
      };
      coarse.row[g].lower = put([&](int h) { return h >= first && h < g; });
      coarse.row[g].outside = put([&](int h) { return h < first || h >= last; });
      coarse.row[g].upper = put([&](int h) { return h > g && h < last; });
      coarse.row[g].end = out;
      for (int h : found.column) found.place[h] = -1;
      coarse.sum[g] = sum;
      coarse.close_row(g);
    }
  });
}

}  // namespace seiche::solver
