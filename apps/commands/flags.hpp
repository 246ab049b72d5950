#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "apps/scene/overrides.hpp"
#include "render/movie_format.hpp"

namespace seiche::apps {

/// A flag that is short for --set KEY; `key`: "section.key", of the option table.
void add_shorthand(CLI::App& verb, const std::string& flag, const std::string& key, std::vector<Override>& overrides,
                   const std::string& type);

/// --set KEY=VALUE. `help`: as in "set a key of the scene".
void add_set(CLI::App& verb, std::vector<Override>& overrides, const std::string& help);

/// The format of a movie.
void add_movie_format(CLI::App& verb, render::MovieFormat& format, const std::string& help);

}  // namespace seiche::apps
