#include "solver/step/mps_run.hpp"
#include "solver/step/mps_steps.hpp"

namespace seiche::solver {

template class Mps<2>;

}  // namespace seiche::solver
