#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/compare/vary.hpp"
#include "apps/scene/overrides.hpp"
#include "apps/scene/scene.hpp"

namespace seiche::apps::compare {

/// A variant of a scene, before it is run.
struct PlannedRun {
  std::string label;
  std::filesystem::path folder;
  Scene scene;
  std::vector<Override> settings;  ///< all that its run is given over the scene file
};

/// One for each combination of the varied values. They write VTU files and readings, but pictures and movies of their
/// own only where `settings` asks for them. Throws BadScene, std::invalid_argument, which also tells runs that are the
/// same, or can't share a picture.
std::vector<PlannedRun> plan(const std::string& scene, const std::vector<std::string>& vary,
                             const std::vector<Override>& settings, const std::filesystem::path& folder);

/// Of what is simulated, sampled and how often; not of how it looks.
std::string simulated_hash(const Scene& scene);

/// Whether its folder holds it already: the same simulation by the same version of the program, at its end.
bool is_done(const PlannedRun& run);

/// Throws BadFolder where its folder holds what running it would destroy: anything but a run of the same simulation
/// that didn't come to its end, or is_done.
void check_kept(const PlannedRun& run);

/// What a run takes, about [bytes].
double memory_of(const Scene& scene);

/// How many runs go beside each other on so many cores, where each takes `need` of the `free` memory; 1 at least.
int runs_at_a_time(std::size_t runs, int cores, double need, double free);

/// What the machine has to spare [bytes].
double free_memory();

}  // namespace seiche::apps::compare
