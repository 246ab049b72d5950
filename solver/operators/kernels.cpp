#include "solver/operators/kernels.hpp"

#include <string>

#include "solver/errors.hpp"

namespace seiche::solver {

Kernel find_kernel(std::string_view wanted, double support, double kf2_alpha) {
  for (const Kernel& kernel : kernel_table(support, kf2_alpha))
    if (name(kernel) == wanted) return kernel;
  throw BadParameters("method.kernel '" + std::string(wanted) + "' is none of KF1 .. KF5");
}

}  // namespace seiche::solver
