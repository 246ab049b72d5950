#include "solver/make_simulation.hpp"

#include <omp.h>

#include "solver/check_parameters.hpp"
#include "solver/motion/excursion.hpp"
#include "solver/sensors/sensor_kinds.hpp"
#include "solver/step/mps.hpp"
#include "solver/tank/shape.hpp"

namespace seiche {

std::vector<Column> sensor_columns(const Parameters& parameters) { return solver::columns_of(parameters); }

Double3 motion_extent(const Parameters& p) { return solver::excursion(p); }

SurfaceMesh tank_surface(const Parameters& parameters) { return solver::wall_surface(parameters); }

std::unique_ptr<Simulation> make_simulation(const Parameters& p, double sample_interval) {
  check_parameters(p);
  omp_set_num_threads(p.threads > 0 ? p.threads : omp_get_num_procs());
  if (p.dimension() == 3) return std::make_unique<solver::Mps<3>>(p, sample_interval);
  return std::make_unique<solver::Mps<2>>(p, sample_interval);
}

}  // namespace seiche
