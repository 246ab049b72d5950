#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "apps/run/loop.hpp"
#include "apps/run/speed.hpp"
#include "apps/scene/scene.hpp"
#include "solver/simulation.hpp"

namespace seiche::apps {

/// What run.json tells of a run. Only `times` differ between two runs of one scene with the same threads.
struct RunRecord {
  std::optional<Ending> ending;  ///< none: the run is still going
  Statistics statistics;
  Times times;
};

/// Schema version of run.json, and of the samples beside it.
constexpr int run_schema = 1;

/// Writes the record as JSON, to a temporary file first, so that a reader never finds half of one.
/// Throws std::runtime_error.
void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunRecord& record);

/// Writes what the scene's own files hold, its motion and its references, which may be gone when the run is shown
/// again; nothing where it has none. Throws std::runtime_error.
void write_samples(const std::filesystem::path& file, const Scene& scene);

/// The scene and the record that write_run_json was given, but for samples and times of stages. Throws nlohmann's
/// exceptions, and std::invalid_argument with the key that doesn't fit, or of another schema version than run_schema.
/// @param folder of the run, for messages
void read_run_json(const nlohmann::json& json, const std::filesystem::path& folder, Scene& scene, RunRecord& record);

/// Adds what write_samples was given. Throws nlohmann's exceptions.
void read_samples(const nlohmann::json& json, Scene& scene);

}  // namespace seiche::apps
