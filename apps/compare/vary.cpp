#include "apps/compare/vary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "apps/scene/lists.hpp"
#include "apps/scene/variants.hpp"
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

}  // namespace

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

}  // namespace seiche::apps::compare
