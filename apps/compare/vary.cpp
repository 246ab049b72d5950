#include "apps/compare/vary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include "apps/lists.hpp"
#include "render/grid_layout.hpp"

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

std::string text_of(const Value& value) {
  return std::visit(
      [](const auto& each) {
        if constexpr (std::is_same_v<std::decay_t<decltype(each)>, std::string>)
          return each;
        else
          return fmt::format("{}", each);
      },
      value);
}

bool speaks_for_itself(const Option& option) { return option.key == "kernel" || option.key == "preset"; }

std::string label_part(const Option& option, const Scene& scene) {
  if (dotted(option) == "particles.spacing") return fmt::format("{:.3g} mm", 1e3 * scene.parameters.particles.spacing);
  const std::string value = text_of(value_of(option, scene));
  if (speaks_for_itself(option)) return value;
  std::string key(option.key);
  std::replace(key.begin(), key.end(), '_', ' ');
  const bool plain = option.unit.empty() || option.unit.find(';') != std::string_view::npos;
  return fmt::format("{} {}{}", key, value, plain ? "" : fmt::format(" {}", option.unit));
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

std::string label_of(const Scene& scene, const std::vector<const Option*>& keys) {
  std::string label;
  for (const Option* key : keys) label += fmt::format("{}{}", label.empty() ? "" : ", ", label_part(*key, scene));
  return label;
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
    const Value first = value_of(option, *scenes.front());
    if (!std::all_of(scenes.begin(), scenes.end(), [&](const Scene* s) { return value_of(option, *s) == first; }))
      keys.push_back(&option);
  }
  return keys;
}

}  // namespace seiche::apps::compare
