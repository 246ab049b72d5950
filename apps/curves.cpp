#include "apps/curves.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/nearest.hpp"
#include "render/curve_choice.hpp"
#include "solver/simulation.hpp"

namespace seiche::apps {

std::optional<std::string> check_curves(const Scene& scene) {
  std::vector<std::string> sensors;
  for (const std::string& column : sensor_columns(scene.parameters)) sensors.push_back(render::bare_name(column));
  for (const std::string& name : render::named_curves(scene.look.curves).value_or(std::vector<std::string>{})) {
    if (std::find(sensors.begin(), sensors.end(), name) != sensors.end()) continue;
    const auto guess = nearest(name, sensors);
    return fmt::format("look.curves names '{}', which is no sensor of this scene{}; it has {}", name,
                       guess ? fmt::format("; did you mean '{}'?", *guess) : "", fmt::join(sensors, ", "));
  }
  return {};
}

}  // namespace seiche::apps
