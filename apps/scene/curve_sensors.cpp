#include "apps/scene/curve_sensors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/common/nearest.hpp"
#include "render/curves.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps {
namespace {

// A name with where it was given.
struct Named {
  std::string sensor, key, origin;
  Position position;
};

// Of several settings of a key the last one wins, here as in the scene.
std::vector<Named> named_sensors(const Settings& settings) {
  std::vector<Named> curves, references;
  for (const Setting& setting : settings.good) {
    if (setting.option != find_option("look", "curves")) continue;
    curves.clear();
    const render::CurveChoice names = render::parse_curves(std::get<std::string>(setting.value));
    for (const std::string& name : names.value_or(std::vector<std::string>{}))
      curves.push_back({name, title(*setting.option), setting.origin, setting.position});
  }
  for (const ListSetting& setting : settings.lists) {
    if (setting.list != find_list("look", "reference")) continue;
    references.clear();
    for (const ListSetting::Table& table : setting.tables)
      for (const ListSetting::Key& key : table.keys)
        if (key.member->key == "of")
          references.push_back(
              {std::get<std::string>(key.value), title(*setting.list, *key.member), key.origin, key.position});
  }
  curves.insert(curves.end(), references.begin(), references.end());
  return curves;
}

}  // namespace

std::vector<Complaint> curve_complaints(const Settings& settings, const Scene& scene) {
  std::vector<std::string> sensors;
  for (const Column& column : sensor_columns(scene.parameters)) sensors.push_back(column.name);
  std::vector<Complaint> complaints;
  for (const Named& named : named_sensors(settings)) {
    if (std::find(sensors.begin(), sensors.end(), named.sensor) != sensors.end()) continue;
    const auto guess = nearest(named.sensor, sensors);
    const std::string message =
        fmt::format("{}: {} = '{}' is no sensor of this scene; expected one of {}{}", named.origin, named.key,
                    named.sensor, fmt::join(sensors, ", "), guess ? fmt::format("; did you mean '{}'?", *guess) : "");
    complaints.push_back({message, named.position});
  }
  return complaints;
}

}  // namespace seiche::apps
