#pragma once
#include <string>

#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// What `seiche check` says of a good scene: the case in three lines.
std::string check_text(const Scene& scene);

}  // namespace seiche::apps
