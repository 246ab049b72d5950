#include "solver/particles/neighbours.hpp"

#include <omp.h>

#include <algorithm>

#include "solver/particles/chunks.hpp"
#include "solver/particles/kept.hpp"

namespace seiche::solver {

template <int D>
bool Neighbours<D>::is_stale(const State<D>& s) {
  if (s.listed_position.size() != s.size()) return true;
  // Pairs that the drift doesn't look at were two cells apart, 2 (radius + skin).
  return drift_.exceeds(skin_, 0.5 * radius_ + skin_, grid_, s);
}

template <int D>
void Neighbours<D>::build(State<D>& s) {
  grid_.sort(s.position, order_);
  s.reorder(order_);
  s.listed_position = s.position;
  const int n = static_cast<int>(s.size());
  resize_kept(row_, n);
  resize_kept(chunk_, chunks_of(n));
  found_.resize(std::max<std::size_t>(found_.size(), omp_get_max_threads()));
  each_chunk<2>(n, [&](int first, int last) {
    std::vector<int>& found = found_[omp_get_thread_num()];
    int count = 0;
    for (int i = first; i < last; ++i) {
      row_[i].first = count;
      if (s.kind[i] != Kind::dummy) count = add_row(s, i, found, count);
      if (s.baffles) count = drop_hidden(s, i, found, row_[i].first, count);
      row_[i].last = count;
    }
    std::vector<int>& kept = chunk_[first / chunk_rows];
    resize_kept(kept, count);
    std::copy_n(found.begin(), count, kept.begin());
  });
}

template <int D>
int Neighbours<D>::add_row(const State<D>& s, int i, std::vector<int>& found, int count) const {
  const Vec<D> ri = s.position[i];
  const double reach = (radius_ + skin_) * (radius_ + skin_);
  grid_.runs_near(ri, [&](int first, int last) {
    if (found.size() < static_cast<std::size_t>(count + last - first)) found.resize(2 * (count + last - first));
    constexpr int block = 32;
    double squared[block];
    int* const index = found.data();
    int out = count;
    for (int begin = first; begin < last; begin += block) {
      const int size = std::min(block, last - begin);
#pragma omp simd
      for (int m = 0; m < size; ++m) squared[m] = squared_distance<D>(s.position, begin + m, ri);
      // Written whether it counts or not: two thirds don't, which no branch would foresee.
      for (int m = 0; m < size; ++m) {
        index[out] = begin + m;
        out += (squared[m] < reach) & (begin + m != i);
      }
    }
    count = out;
  });
  return count;
}

template <int D>
int Neighbours<D>::drop_hidden(const State<D>& s, int i, std::vector<int>& found, int first, int count) const {
  // What stands behind a face is no farther from it than a pair reaches.
  if (first == count || !s.baffles->is_near(s.position[i], 2 * (radius_ + skin_))) return count;
  const auto hidden = [&](int j) { return !s.baffles->sees(s.position[i], s.behind[i], s.position[j], s.behind[j]); };
  const auto end = std::remove_if(found.begin() + first, found.begin() + count, hidden);
  return static_cast<int>(end - found.begin());
}

template class Neighbours<2>;
template class Neighbours<3>;

}  // namespace seiche::solver
