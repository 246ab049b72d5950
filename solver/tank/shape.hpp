#pragma once
#include <memory>
#include <string>

#include "solver/parameters.hpp"
#include "solver/particles/baffles.hpp"
#include "solver/particles/vec.hpp"
#include "solver/surface_mesh.hpp"
#include "solver/tank/wall_point.hpp"

namespace seiche::solver {

/// The wall as seen from a point.
template <int D>
struct Nearest {
  double distance = 0;             ///< to the wall, negative inside the tank [m]
  Vec<D> foot = Vec<D>::Zero();    ///< point of the wall nearest to it [m]
  Vec<D> normal = Vec<D>::Zero();  ///< of the wall at the foot, out of the tank; one of them where patches meet
  int patch = 0;                   ///< that the foot is on, by its place in the mesh
};

/// An axis-aligned box [m].
template <int D>
struct Bounds {
  Vec<D> low, high;

  Vec<D> size() const { return high - low; }
};

/// The inside of a tank: an immutable value that everything which depends on the tank's form asks.
template <int D>
class Shape {
 public:
  virtual ~Shape() = default;

  /// The walls of an open tank go on above its rim.
  virtual Nearest<D> nearest(const Vec<D>& r) const = 0;

  /// What it fills; up to the rim where it is open.
  virtual Bounds<D> bounds() const = 0;

  /// Whether it has a roof.
  virtual bool is_closed() const = 0;

  /// The wall, the roof of an open tank left out.
  virtual SurfaceMesh surface() const = 0;

  /// Points behind the wall in layers (k + 1/2) l0 behind its surface, k < `layers`, about l0 apart, with weights: the
  /// particles that line the tank.
  /// @param reach of a pair, for the faces of points beside a convex edge of the solid [m]
  virtual std::vector<WallPoint<D>> wall_points(int layers, double l0, double reach) const = 0;

  /// Thin walls within it; null where it has none.
  virtual std::shared_ptr<const Baffles<D>> baffles() const { return nullptr; }

  /// For messages, as in "x from 0 to 0.6 m, y from 0 to 0.4 m".
  virtual std::string description() const = 0;
};

/// The tank of a run.
template <int D>
std::shared_ptr<const Shape<D>> make_shape(const Parameters& p);

template <>
std::shared_ptr<const Shape<2>> make_shape(const Parameters& p);
template <>
std::shared_ptr<const Shape<3>> make_shape(const Parameters& p);

/// The wall of a run's tank, in 2-D or 3-D.
SurfaceMesh wall_surface(const Parameters& p);

/// Throws BadParameters for a tank that particles of this spacing can't line.
void check_shape(const Parameters& p);

}  // namespace seiche::solver
