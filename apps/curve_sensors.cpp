#include "apps/curve_sensors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/nearest.hpp"
#include "apps/scene_file.hpp"
#include "render/curve_choice.hpp"
#include "solver/simulation.hpp"

namespace seiche::apps {

void check_curve_sensors(const Scene& scene) {
  std::vector<std::string> sensors;
  for (const std::string& column : sensor_columns(scene.parameters)) sensors.push_back(render::bare_name(column));
  const auto check = [&](const std::string& name, const char* key) {
    if (std::find(sensors.begin(), sensors.end(), name) != sensors.end()) return;
    const auto guess = nearest(name, sensors);
    throw BadScene(fmt::format("{}: {} = '{}' is no sensor of this scene; expected one of {}{}", scene.file, key, name,
                               fmt::join(sensors, ", "), guess ? fmt::format("; did you mean '{}'?", *guess) : ""));
  };
  for (const std::string& name : render::named_curves(scene.look.curves).value_or(std::vector<std::string>{}))
    check(name, "[look] curves");
  for (const render::Reference& reference : scene.look.references) check(reference.of, "[[look.reference]] of");
}

}  // namespace seiche::apps
