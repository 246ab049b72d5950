#pragma once
#include <array>
#include <vector>

#include "solver/particles/vec.hpp"

namespace seiche::solver::modes {

/// Triangles of a plane region that know their neighbours. They are a constrained Delaunay mesh, and stay one: edges
/// inside are flipped until the circle through a triangle's corners holds no corner beyond an edge (Lawson 1977).
class TriangleMesh {
 public:
  static constexpr int wall = -1, surface = -2;

  struct Triangle {
    std::array<int, 3> corners;  ///< anticlockwise
    std::array<int, 3> across;   ///< triangle beyond the edge opposite to each corner, or wall or surface
  };

  /// @param surface_from whether the edge of the boundary that leaves a point is surface
  TriangleMesh(std::vector<Vec<2>> points, const std::vector<std::array<int, 3>>& triangles,
               const std::vector<bool>& surface_from);

  const std::vector<Vec<2>>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }

  const Vec<2>& corner(int t, int k) const { return points_[static_cast<std::size_t>(at(t).corners[turned(k)])]; }
  /// Of the edge opposite to corner k.
  double squared_length(int t, int k) const { return (corner(t, k + 1) - corner(t, k + 2)).squaredNorm(); }
  /// Place in t of the edge that it shares with a neighbour.
  int shared(int t, int neighbour) const;

  /// Enlarges it about (0, 0), then moves it.
  void place(const Vec<2>& origin, double unit);

  /// Puts a point in the middle of the edge opposite to corner k.
  void split(int t, int k);

 private:
  static std::size_t turned(int k) { return static_cast<std::size_t>(k % 3); }
  const Triangle& at(int t) const { return triangles_[static_cast<std::size_t>(t)]; }
  Triangle& at(int t) { return triangles_[static_cast<std::size_t>(t)]; }

  void link(int t, int from, int to);
  int add(const Triangle& triangle);
  bool should_flip(int t, int k) const;
  void flip(int t, int k);
  void make_delaunay(std::vector<int> changed);

  std::vector<Vec<2>> points_;
  std::vector<Triangle> triangles_;
};

}  // namespace seiche::solver::modes
