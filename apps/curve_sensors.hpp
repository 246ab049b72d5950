#pragma once
#include "apps/scene.hpp"

namespace seiche::apps {

/// Throws BadScene where [look] names a sensor that the scene doesn't have.
void check_curve_sensors(const Scene& scene);

}  // namespace seiche::apps
