#pragma once
#include <vector>

#include "solver/tank/box_tree.hpp"
#include "solver/tank/edge.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

/// The wall of a section: closed loops of edges, the liquid on their left.
class Contour {
 public:
  /// Loops that run the other way round are turned: those inside an odd number of others are holes. Throws
  /// BadParameters where an edge has no length, a loop isn't closed or fewer than two edges long, or the wall crosses
  /// or touches itself, with the place.
  explicit Contour(std::vector<std::vector<Edge>> loops);

  /// Exact. At a vertex the sign is that of the mean of both edges' normals (Baerentzen & Aanaes 2005); the normal
  /// there points from the liquid to the vertex, or is that of the edge that r is farther behind.
  Nearest<2> nearest(const Vec<2>& r) const;

  Bounds<2> bounds() const;
  /// [m^2]
  double area() const;
  /// [m]
  double length() const;

  /// Points along each loop, arcs cut into pieces whose chord lies within `tolerance` of them [m]; each begins an edge
  /// of that patch.
  struct Corner {
    Vec<2> position;
    int patch;
  };
  std::vector<std::vector<Corner>> polygons(double tolerance) const;

  const std::vector<std::vector<Edge>>& loops() const { return loops_; }

 private:
  /// An edge that the tree holds, and what its distance is found from.
  struct Held {
    std::size_t loop, edge;
    Vec<2> from, way;       ///< to the other end
    Vec<2> centre, middle;  ///< of an arc, and the unit vector from the one to the arc's middle
    double radius, cosine;  ///< 0 if straight; of half the arc's angle

    double squared_distance(const Vec<2>& r) const;
  };

  std::vector<std::vector<Edge>> loops_;
  std::vector<Held> held_;
  BoxTree<2> tree_;
};

/// A closed polygon, its corners either way round; edge k, from corner k, is patch k.
Contour polygon(const std::vector<Vec<2>>& corners);

}  // namespace seiche::solver
