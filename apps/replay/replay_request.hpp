#pragma once
#include <filesystem>
#include <vector>

#include "apps/replay/frame_list.hpp"
#include "apps/scene/overrides.hpp"
#include "render/movie_format.hpp"

namespace seiche::apps {

/// What the command line of `seiche render` or `seiche movie` asks for.
struct ReplayRequest {
  std::filesystem::path run;                              ///< its folder
  std::filesystem::path output;                           ///< a folder, for `movie` a file; empty: under RUN/render
  render::MovieFormat movie = render::MovieFormat::none;  ///< `render`: one beside the pictures
  std::vector<Override> look;
  Selection frames;
  double speed = 0;  ///< of the movie, times that of the run; 0: not said
  double fps = 0;    ///< of the movie; 0: not said
  bool latest = false;
  bool quiet = false;
  bool overwrite = false;
};

}  // namespace seiche::apps
