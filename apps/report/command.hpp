#pragma once
#include <string>
#include <vector>

#include "apps/scene/overrides.hpp"

namespace seiche::apps::report {

/// A command line as a shell takes it, as in "seiche run quick.toml --spacing 0.01".
/// @param words what comes before the settings, without the program
std::string command_text(const std::vector<std::string>& words, const std::vector<Override>& settings);

}  // namespace seiche::apps::report
