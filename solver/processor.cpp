#include "solver/processor.hpp"

namespace seiche::solver {

std::string processor() { return SEICHE_PROCESSOR; }

}  // namespace seiche::solver
