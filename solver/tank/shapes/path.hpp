#pragma once
#include <functional>
#include <vector>

#include "solver/tank/contour.hpp"

namespace seiche::solver {

/// Edges of which each begins where the one before ends.
struct Path {
  std::vector<Edge> edges;
  bool closed;
};

/// Measures along a path, by its length from the beginning [m]; round a closed path lengths go on.
class Along {
 public:
  explicit Along(const Path& path);

  double length() const { return begin_.back(); }
  Vec<2> point(double s) const;
  /// Integral of the first coordinate over the length from the beginning to s [m^2]: over a path that is turned about
  /// the second axis it gives the area (Pappus).
  double moment(double s) const;
  /// Where edge k begins.
  double begin(std::size_t k) const { return begin_[k]; }

 private:
  std::size_t edge_at(double s) const;

  const Path& path_;
  std::vector<double> begin_, moment_;
};

/// The piece of an edge between two shares of its length.
Edge piece(const Edge& edge, double from, double to);

/// Adds the pieces of an edge whose points are kept; their ends are found by bisection.
/// @param step apart at most are the points that are asked at first [m]
void add_kept(const Edge& edge, const std::function<bool(const Vec<2>&)>& kept, double step, std::vector<Edge>& all);

/// Paths of the edges of a loop, some of which are left out; what lies within the tolerance [m] is one point.
std::vector<Path> joined(const std::vector<Edge>& edges, double tolerance);

/// Angle by which the way turns left between the end of one edge and the beginning of the next, from -pi to pi.
double turn_between(const Edge& before, const Edge& after);

}  // namespace seiche::solver
