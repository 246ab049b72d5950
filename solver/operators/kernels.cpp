#include "solver/operators/kernels.hpp"

#include <string>

#include "solver/errors.hpp"

namespace seiche::solver {

Kernel find_kernel(std::string_view wanted, double support, double kf2_alpha) {
  std::string all;
  for (const Kernel& kernel : kernel_table(support, kf2_alpha)) {
    if (name(kernel) == wanted) return kernel;
    all.append(all.empty() ? "" : ", ").append(name(kernel));
  }
  throw BadParameters("method.kernel '" + std::string(wanted) + "' is none of " + all);
}

}  // namespace seiche::solver
