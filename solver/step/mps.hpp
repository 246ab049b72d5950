#pragma once
#include <omp.h>

#include <memory>

#include "solver/motion/body_force.hpp"
#include "solver/operators/density.hpp"
#include "solver/operators/divergence.hpp"
#include "solver/operators/gradient.hpp"
#include "solver/operators/kernels.hpp"
#include "solver/operators/laplacian.hpp"
#include "solver/operators/separation.hpp"
#include "solver/operators/strain_rate.hpp"
#include "solver/operators/volume.hpp"
#include "solver/pressure/pressure_solver.hpp"
#include "solver/pressure/pressure_system.hpp"
#include "solver/pressure/source.hpp"
#include "solver/pressure/surface_pressure.hpp"
#include "solver/sensors/sensors.hpp"
#include "solver/simulation.hpp"
#include "solver/step/derived.hpp"
#include "solver/step/run_state.hpp"
#include "solver/step/snapshot.hpp"
#include "solver/step/watch.hpp"
#include "solver/tank/standing_wave.hpp"
#include "solver/tank/wall_wetness.hpp"

namespace seiche::solver {

/// A kernel with one support, its constants on the initial lattice, and the pairs within it.
template <int D>
struct Range {
  Kernel w;
  Reference ref;
  std::shared_ptr<Pairs<D>> pairs = std::make_shared<Pairs<D>>();  ///< ranges of one radius share them

  Range(const Parameters& p, double radius)
      : w(find_kernel(p.method.kernel, radius * p.particles.spacing, p.method.kf2_alpha)),
        ref(std::visit([&](auto kernel) { return lattice_reference<D>(kernel, p.particles.spacing); }, w)) {}
};

/// Adds the time that it lives to a stage's total.
class Stage {
 public:
  explicit Stage(double& total) : total_(total), start_(omp_get_wtime()) {}
  ~Stage() { total_ += omp_get_wtime() - start_; }

 private:
  double& total_;
  double start_;
};

/// The moving-particle semi-implicit method (Pan, Zhang, Lu 2008) in D dimensions.
template <int D>
class Mps final : public Simulation {
 public:
  Mps(const Parameters& p, double sample_interval);

  void step(double until) override;
  double time() const override { return s_.time; }
  const Statistics& statistics() const override { return run_.totals; }
  FramePtr frame(long index) override;

  /// To be copied, and resumed from.
  const RunState<D>& state() const { return run_; }

  /// Goes on from a state of a simulation of the same parameters and sample interval.
  void resume(const RunState<D>& state);

 private:
  void step_move_first(double dt);
  void step_project_first(double dt);
  void predict(double dt);
  void refresh_neighbours();
  void list_neighbours();
  void measure_pairs();
  void find_surface();
  void set_force(const BodyForce<D>& force);
  void solve_pressure(double dt, double surface_density);
  void clip_pressure();
  template <class Boundary>
  void assemble(const Boundary& boundary, double dt);
  void solve_system();
  void correct_velocity(double dt);
  void separate();
  void take_out_lost();
  void start_at_rest_in_lab();

  bool ghost_walls() const { return p_.method.wall_model == WallModel::ghosts; }

  /// Calls f(i) for every fluid particle.
  template <class F>
  void each_fluid(F f) {
    const int size = static_cast<int>(s_.size());
#pragma omp parallel for schedule(static)
    for (int i = 0; i < size; ++i)
      if (s_.kind[i] == Kind::fluid) f(i);
  }
  template <class F>
  void move_fluid(F by) {
    each_fluid([&](int i) { s_.position[i] += by(i); });
  }

  Parameters p_;
  Motion motion_;
  Box<D> box_;
  double l0_;
  Range<D> density_range_, gradient_range_, laplacian_range_;
  RunState<D> run_;
  State<D>& s_ = run_.particles;
  Statistics& totals_ = run_.totals;
  Neighbours<D> list_;
  PressureSystem<D> system_;
  std::unique_ptr<PressureSolver> solver_;
  Sensors<D> sensors_;
  Watch<D> watch_;
  double force_divergence_ = 0;  ///< of f [1/s^2]
  WallWetness<D> wetness_;
  VolumeKernel volume_kernel_;
  double whole_volume_;  ///< its sum on the lattice
  SurfaceDepth surface_depth_;

  // Buffers: nothing in them is read by the next step.
  Scalars excess_, divergence_;
  std::vector<int> count_, collisions_;
  Vecs<D> change_;
  Vecs<D> force_, slope_;  ///< f of this step at each fluid particle [m/s^2], and rho f [Pa/m]
  Vecs<D> viscous_;        ///< nu times the Laplacian of u [m/s^2]
  Scalars solution_;
};

/// Compiled in mps_2d.cpp and mps_3d.cpp.
extern template class Mps<2>;
extern template class Mps<3>;

}  // namespace seiche::solver
