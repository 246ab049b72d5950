#pragma once
#include <limits>
#include <optional>

#include "solver/motion/body_force.hpp"
#include "solver/motion/level_start.hpp"
#include "solver/operators/pressure_gradient.hpp"
#include "solver/operators/separation.hpp"
#include "solver/operators/shift.hpp"
#include "solver/operators/surface_detection.hpp"
#include "solver/operators/viscosity.hpp"
#include "solver/pressure/pressure_equation.hpp"
#include "solver/pressure/turn_along_wall.hpp"
#include "solver/simulation.hpp"
#include "solver/step/run_state.hpp"
#include "solver/step/stage.hpp"
#include "solver/step/watch.hpp"

namespace seiche::solver {

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
  void count_kinds();
  void settle();
  bool even_out();
  bool take_even_places();
  void start_at_rest_in_lab();

  BodyForce<D> body(double dt) const {
    return settling_ ? body_force<D>(at_rest_) : body_force<D>(motion_, p_.gravity, s_.time, dt);
  }
  Vec<D> up() const {
    return settling_ ? LevelAxes<D>(at_rest_.gravity).up() : up_in_tank<D>(motion_, p_.gravity, s_.time);
  }

  void step_move_first(double dt);
  void step_project_first(double dt);
  void list_neighbours();
  void find_neighbours();
  void find_surface();
  void predict(const BodyForce<D>& force, double dt);
  void solve_pressure(double dt, double surface_density);
  void clip_pressure();
  void correct(double dt);
  void bend_slope();
  std::optional<Vec<D>> before_other_wall(int i, const Vec<D>& normal) const;
  void turn(const BodyForce<D>& force, double dt);
  void carry_velocity();
  void turn_gain(const BodyForce<D>& force);
  void separate();
  void remove_lost();

  /// Nothing moves through a baffle.
  template <class F>
  void move_fluid(F by) {
    each_fluid(s_, [&](int i) {
      const Vec<D> to = s_.position[i] + by(i);
      s_.position[i] = s_.baffles ? stopped_at_baffles(i, to) : to;
    });
  }
  Vec<D> stopped_at_baffles(int i, Vec<D> to);

  Parameters p_;
  Motion motion_;
  std::shared_ptr<const Shape<D>> tank_;
  double wave_speed_;            ///< sqrt(g H), g the greatest pull [m/s]
  RelativeEquilibrium at_rest_;  ///< at t = 0
  bool settling_ = false;        ///< the liquid becomes even under that, before the run

  RunState<D> run_;  ///< all that a step reads of the one before
  State<D>& s_ = run_.particles;
  Statistics& totals_ = run_.totals;

  // The stages. What they keep is for one step, the neighbour list apart.
  Interactions<D> near_;
  std::unique_ptr<Walls<D>> walls_;
  SurfaceDetection<D> surface_;
  Viscosity<D> viscosity_;
  PressureEquation<D> equation_;
  PressureGradient gradient_;
  ParticleShift shift_;
  Separation<D> separation_;
  Sensors<D> sensors_;
  Watch<D> watch_;

  Forces<D> forces_;  ///< of this step
  Vecs<D> turned_;    ///< of this step: velocity that the Coriolis force alone would leave [m/s]
  Vecs<D> change_;    ///< of this step: of the velocity by the pressure [m/s], then the shift [m]
};

/// Compiled in mps_2d.cpp and mps_3d.cpp.
extern template class Mps<2>;
extern template class Mps<3>;

}  // namespace seiche::solver
