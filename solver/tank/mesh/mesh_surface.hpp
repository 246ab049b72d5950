#pragma once
#include "solver/tank/mesh/closest.hpp"
#include "solver/tank/mesh/creases.hpp"
#include "solver/tank/mesh/mended.hpp"
#include "solver/tank/mesh/winding_tree.hpp"

namespace seiche::solver {

/// How deep behind a wall a point is.
struct Depth {
  double at;   ///< negative in the tank [m]
  Vec<3> way;  ///< its gradient
  Foot foot;   ///< the nearest point of the wall
};

/// The mended surface of a mesh, and all that is found fast about it.
class MeshSurface {
 public:
  explicit MeshSurface(Mended mended);
  MeshSurface(const MeshSurface&) = delete;
  MeshSurface& operator=(const MeshSurface&) = delete;

  const Triangles& mesh() const { return mended_.mesh; }
  const MeshFaults& faults() const { return mended_.faults; }
  const Creases& creases() const { return creases_; }

  Foot foot(const Vec<3>& r) const { return closest_.foot(r); }

  /// Whether r, with this foot, is not in the tank: by the pseudonormal, or by the winding number if parts of the
  /// surface overlap or meet in an edge.
  bool is_outside(const Vec<3>& r, const Foot& foot) const;

  /// The signed distance; but beyond a corner of the tank, where layers are mitred, the greatest distance behind one
  /// of its walls, or the distance over `side_mitre` or `point_mitre` where that is more.
  /// @param within a distance at which or below which the wall is known to be [m]
  Depth depth(const Vec<3>& r, double within = std::numeric_limits<double>::infinity()) const;

 private:
  Mended mended_;
  Creases creases_;
  Closest closest_;
  WindingTree winding_;
};

/// How far a mitre goes, in depths: at corners where two walls meet, and where more do.
inline constexpr double side_mitre = 1.5, point_mitre = 1.8;

}  // namespace seiche::solver
