#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/scene/overrides.hpp"
#include "render/movie_format.hpp"

namespace seiche::apps::compare {

/// What the command line of `seiche compare` asks for.
struct Request {
  std::vector<std::string> what;  ///< one scene, or folders of runs
  std::vector<std::string> vary;  ///< the argument of each --vary
  std::filesystem::path folder;   ///< empty: out/<scene>-compare, or out/compare for folders
  std::vector<Override> settings;
  int threads = 0;  ///< of all runs together; 0: one per core
  render::MovieFormat movie = render::MovieFormat::mp4;
  std::string size = "1920x1080";  ///< of pictures and movie [pixels]
  bool quiet = false;
  bool overwrite = false;
};

/// `seiche compare`: returns what the program exits with. Nothing is run or written before everything that can be is
/// checked. Throws BadScene, BadFolder, render::NoGl, render::NoEncoder, std::invalid_argument.
int compare(const Request& request);

}  // namespace seiche::apps::compare
