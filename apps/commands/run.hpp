#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene/overrides.hpp"

namespace seiche::apps {

/// What the command line of `seiche run` asks for.
struct RunRequest {
  std::string scene;
  std::filesystem::path folder;  ///< empty: out/<scene name>
  std::vector<Override> overrides;
  int threads = 0;  ///< 0: one per core
  bool dry_run = false;
  bool quiet = false;
  bool overwrite = false;
};

/// `seiche run`: returns what the program exits with. Nothing is written before everything that can be is checked.
/// Throws BadScene, BadParameters, BadFolder, render::NoGl, render::NoEncoder, std::invalid_argument.
int run(const RunRequest& request);

}  // namespace seiche::apps
