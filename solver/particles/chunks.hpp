#pragma once
#include <algorithm>
#include <array>
#include <vector>

// Work in chunks of rows whose size doesn't depend on the number of threads: what is computed chunk by chunk, and added
// up in the order of the chunks, has the same bytes however many threads share it.
namespace seiche::solver {

inline constexpr int chunk_rows = 512;

inline int chunks_of(int rows) { return (rows + chunk_rows - 1) / chunk_rows; }

/// Calls f(first row, last row + 1) for each chunk, by several threads where it pays to wake them.
/// @tparam worth chunks that it pays for: where a row takes some nanoseconds, a chunk takes as long as waking does
template <int worth = 12, class F>
void each_chunk(int rows, F f) {
  const int chunks = chunks_of(rows);
#pragma omp parallel for schedule(static) if (chunks >= worth)
  for (int c = 0; c < chunks; ++c) f(c * chunk_rows, std::min((c + 1) * chunk_rows, rows));
}

/// Calls f(i) for each row.
template <class F>
void each_row(int rows, F f) {
  each_chunk(rows, [&](int first, int last) {
    for (int i = first; i < last; ++i) f(i);
  });
}

/// Sums over rows; keeps its buffer.
class ChunkSums {
 public:
  /// N sums at once. f(i, sums) adds what row i has to them.
  template <int N, class F>
  std::array<double, N> add_up(int rows, F f) {
    partial_.resize(std::max<std::size_t>(partial_.size(), N * chunks_of(rows)));
    each_chunk(rows, [&](int first, int last) {
      std::array<double, N> sums{};
      for (int i = first; i < last; ++i) f(i, sums);
      std::copy_n(sums.begin(), N, partial_.begin() + N * (first / chunk_rows));
    });
    std::array<double, N> total{};
    for (int c = 0; c < chunks_of(rows); ++c)
      for (int n = 0; n < N; ++n) total[n] += partial_[N * c + n];
    return total;
  }

 private:
  std::vector<double> partial_;
};

}  // namespace seiche::solver
