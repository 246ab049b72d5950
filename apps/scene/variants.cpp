#include "apps/scene/variants.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "render/curves.hpp"

namespace seiche::apps {
namespace {

// Its value says enough in a folder's name; in a label, so does a spacing's with its unit.
bool speaks_for_itself(const Option& option) { return option.key == "kernel" || option.key == "preset"; }

bool is(const Option& option, std::string_view section, std::string_view key) {
  return option.section == section && option.key == key;
}

// Of the key's value in this scene; empty: none.
std::string_view unit_of(const Option& option, const Scene& scene) {
  if (!is(option, "motion", "amplitude")) return option.unit;
  return row(scene.parameters.motion.harmonic.of).rotation ? "degrees" : "m";
}

// One that is said in millimetres.
bool is_small_length(const Option& option, const Scene& scene) {
  return is(option, "particles", "spacing") || is(option, "fluid", "wave_amplitude") ||
         (is(option, "motion", "amplitude") && !row(scene.parameters.motion.harmonic.of).rotation);
}

std::string label_part(const Option& option, const Scene& scene) {
  const Value value = value_of(option, scene);
  const std::string_view unit = unit_of(option, scene);
  std::string with_unit =
      is_small_length(option, scene)
          ? fmt::format("{:.6g} mm", 1e3 * std::get<double>(value))
          : fmt::format("{}{}{}", text_of(value), unit.empty() ? "" : " ", render::raised_powers(std::string(unit)));
  if (speaks_for_itself(option) || option.key == "spacing") return with_unit;
  std::string key(option.key);
  std::replace(key.begin(), key.end(), '_', ' ');
  return fmt::format("{} {}", key, with_unit);
}

std::string label_of(const Scene& scene, const std::vector<const Option*>& keys) {
  std::string label;
  for (const Option* key : keys) label += fmt::format("{}{}", label.empty() ? "" : ", ", label_part(*key, scene));
  return label;
}

bool differs(const Option& option, const std::vector<const Scene*>& scenes) {
  const Value first = value_of(option, *scenes.front());
  return !std::all_of(scenes.begin(), scenes.end(), [&](const Scene* s) { return value_of(option, *s) == first; });
}

std::string folder_part(const Option& option, const Scene& scene) {
  const std::string value = text_of(value_of(option, scene));
  std::string part = speaks_for_itself(option) ? value : fmt::format("{}-{}", option.key, value);
  for (char& c : part)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '-';
  return part;
}

}  // namespace

bool is_look(const Option& option) { return option.section == "look" || option.section == "output"; }

std::string text_of(const Value& value) {
  return std::visit([](const auto& each) { return fmt::format("{}", each); }, value);
}

std::vector<std::string> labels_of(const std::vector<const Scene*>& scenes, const std::vector<const Option*>& keys) {
  std::vector<const Option*> telling;
  for (const Option* key : keys)
    if (differs(*key, scenes)) telling.push_back(key);
  std::vector<std::string> labels;
  for (const Scene* scene : scenes) labels.push_back(label_of(*scene, telling.empty() ? keys : telling));
  return labels;
}

std::string folder_of(const Scene& scene, const std::vector<const Option*>& keys) {
  std::string folder;
  for (const Option* key : keys) folder += fmt::format("{}{}", folder.empty() ? "" : "_", folder_part(*key, scene));
  return folder;
}

std::vector<const Option*> differences(const std::vector<const Scene*>& scenes) {
  std::vector<const Option*> keys;
  for (const Option& option : options()) {
    if (is_look(option)) continue;
    if (differs(option, scenes)) keys.push_back(&option);
  }
  return keys;
}

}  // namespace seiche::apps
