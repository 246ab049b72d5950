#pragma once
#include <string>
#include <vector>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// A key that the command line sets over the scene file.
struct Override {
  std::string origin;  ///< how the user wrote it, as in "--set motion.amplitude=0.01"; messages name it
  std::string key;     ///< "section.key", or "key" for one above the sections
  std::string value;
};

/// The argument of one --set, "key=value". Without "=" the key is taken to be all of it, and the value empty.
Override parse_set(const std::string& text);

/// Overrides found in the option table; the rest are complaints, each with the nearest right name.
Settings override_settings(const std::vector<Override>& overrides);

}  // namespace seiche::apps
