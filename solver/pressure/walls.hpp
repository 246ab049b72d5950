#pragma once
#include <memory>

#include "solver/operators/interactions.hpp"
#include "solver/pressure/boundary.hpp"
#include "solver/pressure/forces.hpp"
#include "solver/pressure/pressure_system.hpp"
#include "solver/pressure/surface_pressure.hpp"
#include "solver/tank/wall_wetness.hpp"

namespace seiche::solver {

/// A wall model: what walls are to the number density, to the pressure equation and to the pressure's gradient.
template <int D>
class Walls {
 public:
  virtual ~Walls() = default;

  /// Call when the list was made anew.
  virtual void relist(const Neighbours<D>&, const State<D>&) {}

  /// Sets how wet walls are, as which they count as neighbours.
  /// @param up against gravity, in the tank's axes; 0 where there is none
  virtual void wet(const Range<D>&, const Vec<D>& /*up*/, State<D>&) {}

  /// Gives free-surface particles their pressure, and writes the equation's matrix and what walls and surface add to
  /// its right-hand side.
  /// @param rho of the liquid above the centres of free-surface particles [kg/m^3]; 0: p = 0 there
  virtual void assemble(const Interactions<D>& near, const Forces<D>& forces, double rho, State<D>& s,
                        PressureSystem<D>& system) = 0;

  /// Gives wall particles that are no unknowns their pressure, once the equation is solved.
  virtual void extend_pressure(const Range<D>&, const Forces<D>&, State<D>&) {}

  /// Slope of the pressure across walls, at each fluid particle, where the pressure equation itself balances the body
  /// force, which then joins the velocity with the pressure's gradient. Null where wall particles have pressures of
  /// their own, and the force joins the velocity before.
  virtual const Vecs<D>* slope(const Forces<D>&) const = 0;
};

/// Behind a wall the pressure goes on with the slope that holds still liquid (GhostBoundary).
template <int D>
class GhostWalls final : public Walls<D> {
 public:
  GhostWalls(const Kernel& w, double l0)
      : wetness_(std::visit([&](auto kernel) { return WallWetness<D>(kernel, l0); }, w)),
        depth_(std::visit([&](auto kernel) { return surface_depth<D>(kernel, l0); }, w)) {}

  void relist(const Neighbours<D>& list, const State<D>& s) override { wetness_.relist(list, s); }
  void wet(const Range<D>& range, const Vec<D>& up, State<D>& s) override {
    wetness_(*range.pairs, range.ref.n0, up, s);
  }
  void assemble(const Interactions<D>& near, const Forces<D>& forces, double rho, State<D>& s,
                PressureSystem<D>& system) override {
    set_surface_pressure(rho, forces.body, forces.viscous, depth_, s.density, s);
    const GhostBoundary<D> boundary{s,           s.density, s.near_surface, near.density.ref.n0, near.laplacian.ref.n0,
                                    forces.slope};
    system.assemble(*near.laplacian.pairs, definite * near.laplacian.ref.n0, boundary, s);
  }
  void extend_pressure(const Range<D>& range, const Forces<D>& forces, State<D>& s) override {
    extend_to_walls(*range.pairs, forces.slope, s);
  }
  const Vecs<D>* slope(const Forces<D>& forces) const override { return &forces.slope; }

 private:
  WallWetness<D> wetness_;
  SurfaceDepth depth_;
};

/// Wall particles have pressures of their own, and p = 0 at the free surface (PaperBoundary). All walls are wet.
template <int D>
class ParticleWalls final : public Walls<D> {
 public:
  void assemble(const Interactions<D>& near, const Forces<D>&, double, State<D>& s,
                PressureSystem<D>& system) override {
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.surface[i]) s.pressure[i] = 0;
    system.assemble(*near.laplacian.pairs, definite * near.laplacian.ref.n0, PaperBoundary<D>{s}, s);
  }
  const Vecs<D>* slope(const Forces<D>&) const override { return nullptr; }
};

/// Those of the model that the scene names.
template <int D>
std::unique_ptr<Walls<D>> make_walls(const Parameters& p, const Kernel& density_kernel) {
  if (p.method.wall_model == WallModel::particles) return std::make_unique<ParticleWalls<D>>();
  return std::make_unique<GhostWalls<D>>(density_kernel, p.particles.spacing);
}

}  // namespace seiche::solver
