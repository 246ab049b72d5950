#pragma once
#include <filesystem>
#include <optional>

#include "apps/loop.hpp"
#include "apps/scene.hpp"
#include "apps/speed.hpp"
#include "solver/simulation.hpp"

namespace seiche::apps {

/// What run.json tells of a run. Only `times` differ between two runs of one scene with the same threads.
struct RunRecord {
  std::optional<Ending> ending;  ///< none: the run is still going
  Statistics statistics;
  Times times;
};

/// Writes the record as JSON, to a temporary file first, so that a reader never finds half of one.
/// Throws std::runtime_error.
void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunRecord& record);

}  // namespace seiche::apps
