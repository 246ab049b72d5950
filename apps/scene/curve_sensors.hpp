#pragma once
#include <vector>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// A complaint for each sensor that [look] names and the scene doesn't have. `settings` are those that made the scene.
std::vector<Complaint> curve_complaints(const Settings& settings, const Scene& scene);

}  // namespace seiche::apps
