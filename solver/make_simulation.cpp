#include "solver/make_simulation.hpp"

#include <omp.h>

#include <numbers>

#include "solver/check_parameters.hpp"
#include "solver/modes/tank_modes.hpp"
#include "solver/motion/excursion.hpp"
#include "solver/motion/wave_speed.hpp"
#include "solver/sensors/sensor_kinds.hpp"
#include "solver/step/mps.hpp"
#include "solver/tank/body.hpp"
#include "solver/tank/level.hpp"
#include "solver/tank/measures.hpp"
#include "solver/tank/pools.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {

std::vector<Column> sensor_columns(const Parameters& parameters) { return solver::columns_of(parameters); }

Double3 motion_extent(const Parameters& p) { return solver::excursion(p); }

SurfaceMesh tank_surface(const Parameters& parameters) { return solver::wall_surface(parameters); }

Parameters::Tank initial_tank(TankShape shape) { return solver::initial_tank(shape); }

void check_tank(const Parameters& p) { solver::check_shape(p); }

TankMeasures tank_measures(const Parameters& p) {
  const SurfaceMesh wall = solver::on_level_axes(solver::wall_surface(p), p.gravity);
  return {solver::volume_of(wall), solver::area_of(wall), wall.size()[1], solver::liquid_volume(p)};
}

double depth_holding(const Parameters& p, double volume) {
  const SurfaceMesh wall = solver::on_level_axes(solver::wall_surface(p), p.gravity);
  return solver::level_holding(wall, volume) - wall.low()[1];
}

std::string mended_of(const Parameters& p) {
  if (p.tank.shape != TankShape::mesh) return {};
  return solver::text_of(solver::MeshTank(p.tank.mesh, p.particles.spacing).faults());
}

std::vector<NaturalMode> natural_modes(const Parameters& p, int count) {
  if (p.gravity.size() == 0 || p.fluid.column > 0 || !p.fluid.seeds.empty()) return {};
  std::vector<NaturalMode> modes;
  for (const solver::modes::TankMode& mode : solver::modes::tank_modes(p, count))
    modes.push_back({2 * std::numbers::pi / mode.frequency, mode.wave});
  return modes;
}

double greatest_pull(const Parameters& p) {
  const solver::Motion motion(p.motion);
  return p.dimension() == 3 ? solver::greatest_pull(p, solver::make_shape<3>(p)->bounds(), motion)
                            : solver::greatest_pull(p, solver::make_shape<2>(p)->bounds(), motion);
}

std::unique_ptr<Simulation> make_simulation(const Parameters& p, double sample_interval) {
  check_parameters(p);
  omp_set_num_threads(p.threads > 0 ? p.threads : omp_get_num_procs());
  if (p.dimension() == 3) return std::make_unique<solver::Mps<3>>(p, sample_interval);
  return std::make_unique<solver::Mps<2>>(p, sample_interval);
}

}  // namespace seiche
