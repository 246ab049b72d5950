#include "apps/commands/info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <omp.h>

#include <Eigen/Core>

#include "apps/run/run_info.hpp"
#include "render/outputs.hpp"
#include "solver/pressure/pressure_solver.hpp"
#include "solver/processor.hpp"

namespace seiche::apps {
namespace {

std::string gl() {
  try {
    return render::gl_description();
  } catch (const render::NoGl& error) {
    return error.what();
  }
}

std::string ffmpeg() {
  try {
    const render::Ffmpeg found = render::find_ffmpeg();
    return fmt::format("{}\n  encoders  {}", found.version, fmt::join(found.encoders, ", "));
  } catch (const render::NoEncoder& error) {
    return error.what();
  }
}

}  // namespace

std::string info_text() {
  return fmt::format(
      "seiche {}\n"
      "  GL        {}\n"
      "  VTK       {}\n"
      "  ffmpeg    {}\n"
      "  Eigen     {}.{}.{}\n"
      "  CHOLMOD   {} (SuiteSparse)\n"
      "  solver    for {}, {} threads\n",
      version(), gl(), render::vtk_version(), ffmpeg(), EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
      solver::cholmod_version(), solver::processor(), omp_get_num_procs());
}

}  // namespace seiche::apps
