#pragma once
#include <vector>

#include "solver/particles/baffle_face.hpp"

namespace seiche::solver {

/// The sides of the thin walls within a tank, which hide what lies behind them: two particles of liquid are neighbours
/// only if the way from one to the other enters none, and a particle that stands for the solid behind a side is one
/// only if that is the first which the way to it enters. So each side of a wall thinner than the reach of a pair has a
/// solid of its own, also where the other side's liquid is.
template <int D>
class Baffles {
 public:
  explicit Baffles(std::vector<BaffleFace<D>> faces) : faces_(std::move(faces)) {}

  const std::vector<BaffleFace<D>>& faces() const { return faces_; }

  /// The first face that the way enters, of several in one place the one that comes first here; -1 if it enters none.
  int entered(const Vec<D>& from, const Vec<D>& to) const;

  /// Whether two particles are neighbours.
  /// @param behind_a, behind_b the faces whose solid they stand for, -1 of liquid and of what lies behind the tank's
  ///        wall
  bool sees(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const;

  /// Whether liquid at one point sees liquid at another.
  bool sees(const Vec<D>& a, const Vec<D>& b) const { return sees(a, -1, b, -1); }

  /// Whether the rim of a plate is nearer to r than that [m].
  bool is_at_rim(const Vec<D>& r, double distance) const;

  /// Whether any face is nearer to r than that [m].
  bool is_near(const Vec<D>& r, double distance) const;

 private:
  /// Whether liquid can stand before both sides, as in a corner between them: each particle's foot is before the
  /// other's side.
  bool face_each_other(const Vec<D>& a, int behind_a, const Vec<D>& b, int behind_b) const;

  std::vector<BaffleFace<D>> faces_;
};

}  // namespace seiche::solver
