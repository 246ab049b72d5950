#pragma once
#include <string>

namespace seiche::apps {

/// A JSON Schema (draft 2020-12) of scene files, made of the tables of options and of lists; defaults are those of
/// preset "stabilised". Editors of TOML complete and check scenes by it.
std::string scene_json_schema();

}  // namespace seiche::apps
