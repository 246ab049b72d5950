#pragma once
#include <string>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// The keys of a scene file's text that the option table knows, with their values; the rest are complaints, each with
/// the nearest right name. `file` is the text's name in messages.
Settings toml_settings(const std::string& toml, const std::string& file);

}  // namespace seiche::apps
