#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/replay/frame_list.hpp"
#include "apps/scene/overrides.hpp"

namespace seiche::apps {

/// What the command line of `seiche render` or `seiche movie` asks for.
struct ReplayRequest {
  std::filesystem::path run;     ///< its folder
  std::filesystem::path output;  ///< a folder, for `movie` a file; empty: under RUN/render
  std::string movie = "none";    ///< `render`: one beside the pictures; mp4 | webm | gif | none
  std::vector<Override> look;
  Selection frames;
  double speed = 0;  ///< of the movie, times that of the run; 0: not said
  double fps = 0;    ///< of the movie; 0: not said
  bool latest = false;
  bool quiet = false;
  bool overwrite = false;
};

/// `seiche render`: draws a run's stored frames again. Returns what the program exits with. Nothing is written before
/// everything that can be is checked. Throws BadFolder, BadScene, render::NoGl, render::NoEncoder,
/// std::invalid_argument.
int replay(const ReplayRequest& request);

/// `seiche movie`: makes another movie, of the run's pictures, or of its stored frames where it has none or is to look
/// otherwise. As replay().
int replay_movie(const ReplayRequest& request);

}  // namespace seiche::apps
