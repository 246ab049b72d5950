#pragma once
#include <string>
#include <vector>

#include "apps/common/errors.hpp"

namespace seiche::apps {

/// What is wrong with a scene, as the user reads it.
inline std::string errors_of(const std::string& toml, const std::vector<Override>& overrides = {}) {
  try {
    parse_scene(toml, "x.toml", overrides);
  } catch (const BadScene& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace seiche::apps
