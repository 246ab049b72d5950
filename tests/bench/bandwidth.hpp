#pragma once
#include <string>
#include <vector>

namespace seiche::bench {

/// How fast a kernel moves memory.
struct Bandwidth {
  std::string name;
  int threads = 0;
  double bytes = 0;    ///< that a run must move
  double seconds = 0;  ///< the fastest run's
  double rate() const { return bytes / seconds; }
};

/// The triad a_i = b_i + s c_i of STREAM (McCalpin 1995), 24 bytes an element, its arrays far larger than any cache,
/// with 1 and 2 threads; then the product of the pressure equation's matrix of 200,000 particles with a vector: values,
/// columns and row starts, x read once, y written.
std::vector<Bandwidth> measure_bandwidth();

/// With each one's share of the triad of as many threads.
std::string bandwidth_csv(const std::vector<Bandwidth>& all);

}  // namespace seiche::bench
