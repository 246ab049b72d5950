#include "solver/make_simulation.hpp"

#include <omp.h>

#include "solver/check_parameters.hpp"
#include "solver/motion/motion.hpp"
#include "solver/sensors/sensor_list.hpp"
#include "solver/step/mps.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {

std::vector<std::string> sensor_columns(const Parameters& parameters) { return solver::column_names(parameters); }

Double3 motion_extent(const Parameters& p) {
  // The walls' particles stand outside of the wall's surface.
  const SurfaceMesh tank = solver::tank_surface(p);
  const double walls = solver::wall_layers(p.method) * p.particles.spacing;
  Double3 low = tank.low(), high = tank.high();
  for (std::size_t axis = 0; axis < 3; ++axis) low[axis] -= walls, high[axis] += walls;
  return solver::Motion(p.motion).extent(low, high);
}

SurfaceMesh tank_surface(const Parameters& parameters) { return solver::tank_surface(parameters); }

std::unique_ptr<Simulation> make_simulation(const Parameters& p, double sample_interval) {
  check_parameters(p);
  omp_set_num_threads(p.threads > 0 ? p.threads : omp_get_num_procs());
  if (p.dimension() == 3) return std::make_unique<solver::Mps<3>>(p, sample_interval);
  return std::make_unique<solver::Mps<2>>(p, sample_interval);
}

}  // namespace seiche
