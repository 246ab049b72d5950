#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "apps/common/exit_codes.hpp"

// The command `seiche`: sees to what must hold before the program proper, seiche-core, can be loaded, and becomes it.

namespace {

namespace fs = std::filesystem;

// seiche-core links libOSMesa ahead of VTK. Without it the dynamic loader would end it before it could say a word.
bool has_osmesa() {
  if (dlopen(SEICHE_OSMESA, RTLD_LAZY)) return true;
  std::fprintf(stderr,
               "seiche: can't load OSMesa, which draws without a display (%s): install Debian's package libosmesa6, as "
               "in 'apt install libosmesa6'\n",
               dlerror());
  return false;
}

// In ../libexec of an installation, in libexec of a build.
fs::path core_beside(const fs::path& program) {
  const fs::path folder = program.parent_path();
  const fs::path installed = folder.parent_path() / "libexec" / "seiche-core";
  return fs::exists(installed) ? installed : folder / "libexec" / "seiche-core";
}

}  // namespace

int main(int, char** arguments) {
  if (!has_osmesa()) return seiche::apps::no_gl;
  // Threads that spin while they wait are ten times slower on a busy machine, threads that sleep at once twice as slow
  // on a free one: spin for some microseconds. libgomp reads these when it is loaded.
  setenv("OMP_WAIT_POLICY", "passive", 0);
  setenv("GOMP_SPINCOUNT", "300", 0);
  std::error_code error;
  const fs::path core = core_beside(fs::read_symlink("/proc/self/exe", error));
  execv(core.c_str(), arguments);
  std::fprintf(stderr, "seiche: can't start %s: %s; install seiche anew\n", core.c_str(), std::strerror(errno));
  return seiche::apps::failed;
}
