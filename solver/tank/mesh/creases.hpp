#pragma once
#include "solver/tank/mesh/closest.hpp"
#include "solver/tank/mesh/edges.hpp"

namespace seiche::solver {

/// Turn of an edge from which on it is one, and not part of a curved wall [rad].
inline constexpr double least_turn = 0.5;

/// An edge of a tank: two walls that meet.
struct Crease {
  int low, high;  ///< its ends
  double turn;    ///< of the normal; positive where the liquid side is under 180 degrees [rad]
  Vec<3> normals[2];
};

/// The normals of a closed surface, and its edges. What turns less than `least_turn` passes for a curved wall.
class Creases {
 public:
  explicit Creases(const Triangles& mesh);

  const Vec<3>& normal(int triangle) const { return normals_[triangle]; }
  const std::vector<Crease>& all() const { return creases_; }

  /// Points out of the tank wherever r - foot does: at a side the mean of both normals, at a corner that of the
  /// triangles by their angles there (Baerentzen & Aanaes 2005).
  Vec<3> pseudonormal(const Foot& foot) const;

  /// That of the curved wall which the triangles stand for, where the foot lies on its triangle.
  Vec<3> smooth_normal(const Foot& foot) const;

  /// Whether the foot is on an edge with the liquid on less than 180 degrees.
  bool is_corner(const Foot& foot) const;

  /// Normals of the triangles that meet at a foot.
  Vecs<3> normals_at(const Foot& foot) const;
  /// Of those that meet at a point of the mesh; those alike are there once.
  Vecs<3> normals_at(int point) const;

 private:
  const Triangles* mesh_;
  Vecs<3> normals_, at_points_, at_corners_;
  std::vector<std::array<int, 3>> beyond_;      ///< the triangle beyond each side; -1 if there are several
  std::vector<std::array<bool, 3>> is_corner_;  ///< of each side
  std::vector<bool> has_corner_;                ///< of each point
  std::vector<Crease> creases_;
  std::vector<int> first_, around_;  ///< triangles around each point
};

}  // namespace seiche::solver
