#pragma once
#include <optional>
#include <string>

#include "apps/scene.hpp"

namespace seiche::apps {

/// What is wrong where [look] names a sensor that the run doesn't have.
std::optional<std::string> check_curves(const Scene& scene);

}  // namespace seiche::apps
