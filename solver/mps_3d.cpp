#include "solver/mps_steps.hpp"

namespace seiche::solver {

template <>
std::unique_ptr<Simulation> make_mps<3>(const Parameters& p, double sample_interval) {
  return make_for_kernel<3>(p, sample_interval);
}

}  // namespace seiche::solver
