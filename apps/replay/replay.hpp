#pragma once
#include "apps/replay/replay_request.hpp"

namespace seiche::apps {

/// `seiche render`: draws a run's stored frames again. Returns what the program exits with. Nothing is written before
/// everything that can be is checked. Throws BadFolder, BadScene, render::NoGl, render::NoEncoder,
/// std::invalid_argument.
int replay(const ReplayRequest& request);

/// `seiche movie`: makes another movie, of the run's pictures, or of its stored frames where it has none or is to look
/// otherwise. As replay().
int replay_movie(const ReplayRequest& request);

}  // namespace seiche::apps
