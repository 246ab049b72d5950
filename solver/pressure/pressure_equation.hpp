#pragma once
#include "solver/operators/divergence.hpp"
#include "solver/operators/volume.hpp"
#include "solver/pressure/pressure_solver.hpp"
#include "solver/pressure/source.hpp"
#include "solver/pressure/walls.hpp"

namespace seiche::solver {

/// Equation (10) for the pressure at the end of a step: its source, its matrix with what walls and surface add, and its
/// solver, each as the scene names it.
template <int D>
class PressureEquation {
 public:
  /// @param wave_speed sqrt(g H) [m/s]
  PressureEquation(const Parameters& p, double wave_speed)
      : source_(make_source(p, wave_speed)),
        solver_(make_pressure_solver(p.pressure.solver, p.pressure.tolerance, p.pressure.max_iterations)),
        volume_kernel_(p.particles.spacing),
        whole_volume_(1 + lattice_reference<D>(volume_kernel_, p.particles.spacing).n0) {}

  /// Writes both sides for a step of length dt [s].
  /// @param surface_density, s as those of Walls::assemble
  void assemble(Walls<D>& walls, const Interactions<D>& near, const Forces<D>& forces, double surface_density,
                double dt, State<D>& s) {
    walls.assemble(near, forces, surface_density, s, system_);
    std::visit([&](const auto& source) { add(source, near, dt * forces.divergence, dt, s); }, source_);
  }

  /// Of u* by the last assemble(); empty where the source needs no divergence.
  const VelocityGradients<D>& velocity_gradient() const { return gradient_; }

  bool is_finite() { return system_.rhs().allFinite(); }

  /// Solves it for the state's pressure, starting from what that is, which stays if the solver doesn't converge.
  SolveReport solve(State<D>& s) {
    const int rows = system_.rows();
    if (rows == 0) return {.converged = true};
    resize_kept(solution_, rows);
    for (int k = 0; k < rows; ++k) solution_[k] = s.pressure[system_.particle(k)];
    const SolveReport report = solver_->solve(system_.matrix(), system_.rhs(), VectorView(solution_.data(), rows));
    for (int k = 0; k < rows && report.converged; ++k) s.pressure[system_.particle(k)] = solution_[k];
    return report;
  }

 private:
  void add(const DensitySource& source, const Interactions<D>& near, double, double dt, const State<D>& s) {
    const double n0 = near.density.ref.n0;
    add_at_each(near.laplacian.ref, [&](int i) { return source((s.density[i] - n0) / n0, dt); });
  }

  /// @param by_force what the body force, not yet in u*, will add to its divergence [1/s]
  void add(const MixedSource& source, const Interactions<D>& near, double by_force, double dt, const State<D>& s) {
    resize_kept(divergence_, s.size());
    resize_kept(excess_, s.size());
    resize_kept(gradient_, s.size());
    velocity_divergence(*near.density.pairs, near.density.ref.n0, s, divergence_, gradient_);
    volume_excess(volume_kernel_, whole_volume_, near.list, s, excess_);
    add_at_each(near.laplacian.ref,
                [&](int i) { return source(divergence_[i] + by_force, excess_[i], s.near_surface[i], dt); });
  }

  /// Adds f(i), brought to the scale of PressureSystem, to the right-hand side of each unknown i.
  template <class F>
  void add_at_each(const Reference& ref, F f) {
    const double scale = ref.lambda * ref.n0 / (2 * D);
    VectorView rhs = system_.rhs();
#pragma omp parallel for schedule(static)
    for (int k = 0; k < system_.rows(); ++k) rhs[k] += scale * f(system_.particle(k));
  }

  Source source_;
  PressureSystem<D> system_;
  std::unique_ptr<PressureSolver> solver_;
  VolumeKernel volume_kernel_;
  double whole_volume_;  ///< its sum on the lattice
  Scalars divergence_, excess_, solution_;
  VelocityGradients<D> gradient_;
};

}  // namespace seiche::solver
