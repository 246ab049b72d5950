#pragma once
#include <CLI/CLI.hpp>

namespace seiche::apps {

/// `seiche schema`: prints what a scene file may hold.
void add_schema(CLI::App& app);

}  // namespace seiche::apps
