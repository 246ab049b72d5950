#include "apps/compare/vary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "apps/scene/lists.hpp"
#include "render/curves.hpp"
#include "render/panels.hpp"

namespace seiche::apps::compare {
namespace {

// The option behind a key; complains as --set does.
const Option* option_of(const Override& setting) {
  for (const List& list : lists())
    if (dotted(list) == setting.key)
      throw std::invalid_argument(fmt::format("{}: a list can't be varied; vary a key of one value", setting.origin));
  const Settings found = override_settings({setting});
  if (found.good.empty()) throw std::invalid_argument(found.complaints.front().message);
  return found.good.front().option;
}

// Its value says enough in a folder's name; in a label, so does a spacing's with its unit.
bool speaks_for_itself(const Option& option) { return option.key == "kernel" || option.key == "preset"; }

// Of the key's value in this scene; empty: none.
std::string_view unit_of(const Option& option, const Scene& scene) {
  const auto either = option.unit.find("; roll: ");  // as in "m; roll: degrees"
  if (either == std::string_view::npos) return option.unit;
  return scene.parameters.motion.type == "roll" ? option.unit.substr(option.unit.rfind(' ') + 1)
                                                : option.unit.substr(0, either);
}

bool is_small_length(const Option& option, std::string_view unit) {
  return unit == "m" && (option.key == "spacing" || option.key.ends_with("amplitude"));
}

std::string label_part(const Option& option, const Scene& scene) {
  const Value value = value_of(option, scene);
  const std::string_view unit = unit_of(option, scene);
  const std::string with_unit =
      is_small_length(option, unit)
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

Vary parse_vary(const std::string& text) {
  const std::string origin = "--vary " + text;
  const auto equals = std::min(text.find('='), text.size());
  const std::string key = text.substr(0, equals);
  Vary vary{option_of({origin, key, ""}), {}};
  if (is_look(*vary.option))
    throw std::invalid_argument(fmt::format(
        "{}: {} says how all variants look; vary what is simulated, and give {} with --set", origin, key, key));
  for (std::size_t start = equals + 1; start <= text.size();) {
    const auto comma = std::min(text.find(',', start), text.size());
    const std::string value = text.substr(start, comma - start);
    if (value.empty()) break;
    vary.values.push_back({fmt::format("--vary {}={}", key, value), key, value});
    start = comma + 1;
    if (comma == text.size()) return vary;
  }
  throw std::invalid_argument(
      fmt::format("{}: a value is missing; expected KEY=VALUE,VALUE, as in method.kernel=KF1,KF3", origin));
}

std::vector<std::vector<Override>> combinations(const std::vector<Vary>& varied, const std::vector<Override>& fixed) {
  std::vector<std::vector<Override>> all{{}};
  for (std::size_t i = 0; i < varied.size(); ++i) {
    const std::string key = dotted(*varied[i].option);
    const bool twice = std::any_of(varied.begin(), varied.begin() + static_cast<std::ptrdiff_t>(i),
                                   [&](const Vary& other) { return other.option == varied[i].option; });
    if (twice) throw std::invalid_argument(fmt::format("{} is varied twice; give all its values in one --vary", key));
    for (const Override& each : fixed)
      if (each.key == key)
        throw std::invalid_argument(fmt::format("{}: {} is varied; leave one of both", each.origin, key));
    std::vector<std::vector<Override>> longer;
    for (const auto& before : all)
      for (const Override& value : varied[i].values) {
        longer.push_back(before);
        longer.back().push_back(value);
      }
    all = std::move(longer);
  }
  if (all.size() > render::most_panels)
    throw std::invalid_argument(
        fmt::format("{} variants are too many; a picture has room for {}", all.size(), render::most_panels));
  return all;
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

}  // namespace seiche::apps::compare
