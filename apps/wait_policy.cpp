#include "apps/wait_policy.hpp"

#include <unistd.h>

#include <cstdlib>

namespace seiche::apps {

void choose_passive_waiting(char** arguments) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", arguments);
  // Without /proc the program goes on here, slower at worst.
}

}  // namespace seiche::apps
