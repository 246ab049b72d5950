#pragma once
#include <CLI/CLI.hpp>

#include "apps/replay/replay.hpp"

namespace seiche::apps {

/// `seiche render` and `seiche movie`: `code` becomes what the program exits with.
void add_render(CLI::App& app, ReplayRequest& request, int& code);
void add_movie(CLI::App& app, ReplayRequest& request, int& code);

}  // namespace seiche::apps
