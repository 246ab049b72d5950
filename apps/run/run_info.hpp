#pragma once
#include "apps/scene/scene.hpp"
#include "solver/run_info.hpp"

namespace seiche::apps {

/// The program's version, as in "0.1.0".
const char* version();

/// What every output of the scene's run is told.
RunInfo run_info(const Scene& scene);

}  // namespace seiche::apps
