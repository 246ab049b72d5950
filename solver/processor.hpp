#pragma once
#include <string>

namespace seiche::solver {

/// The processor that this build of the solver is for, as in "x86-64-v3": the loader takes the best that runs here.
std::string processor();

}  // namespace seiche::solver
