#include "apps/scene/toml_lists.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/common/nearest.hpp"

namespace seiche::apps {
namespace {

void complain(const Place& place, const std::string& message, Settings& out) {
  out.complaints.push_back({fmt::format("{}: {}", place.origin, message), place.position});
}

std::string hint(const List& list, const std::string& key) {
  std::vector<std::string> keys;
  for (const Member& member : list.members) keys.emplace_back(member.key);
  const auto guess = nearest(key, keys);
  return guess ? fmt::format("did you mean '{}'?", *guess) : fmt::format("expected one of {}", fmt::join(keys, ", "));
}

ListSetting::Table read_table(const List& list, const toml::table& table, const Placing& place, Settings& out) {
  const Place start = place(table.source());
  ListSetting::Table result{start.origin, start.position, {}};
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    const Member* member = find_member(list, name);
    if (!member) {
      const std::string message = fmt::format("unknown key {} {}; {}", title(list), name, hint(list, name));
      complain(place(key.source()), message, out);
    } else if (const auto value = value_of_node(node)) {
      const Place at = place(node.source());
      result.keys.push_back({at.origin, at.position, member, *value});
    } else {
      complain(place(key.source()),
               fmt::format("{} takes one value; expected {}", title(list, *member), expected(*member)), out);
    }
  }
  return result;
}

}  // namespace

namespace {

std::optional<Numbers> numbers_of(const toml::array& array) {
  Numbers numbers;
  for (const toml::node& node : array) {
    const auto number = node.value<double>();
    if (!number || !node.is_number()) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<Points> points_of(const toml::array& array) {
  Points points;
  for (const toml::node& node : array) {
    const auto pair = node.is_array() ? numbers_of(*node.as_array()) : std::nullopt;
    if (!pair || pair->size() != 2) return {};
    points.push_back({(*pair)[0], (*pair)[1]});
  }
  return points;
}

std::optional<Rows> rows_of(const toml::array& array) {
  Rows rows;
  for (const toml::node& node : array) {
    const auto row = node.is_array() ? numbers_of(*node.as_array()) : std::nullopt;
    if (!row) return {};
    rows.push_back(*row);
  }
  return rows;
}

}  // namespace

std::optional<Value> value_of_text(const std::string& text) {
  try {
    const toml::table root = toml::parse("value = " + text);
    return root.size() == 1 ? value_of_node(*root.get("value")) : std::nullopt;
  } catch (const toml::parse_error&) {
    return {};
  }
}

std::optional<Value> value_of_node(const toml::node& node) {
  if (const auto value = node.value_exact<bool>()) return *value;
  if (const auto value = node.value_exact<std::int64_t>()) return *value;
  if (const auto value = node.value_exact<double>()) return *value;
  if (const auto value = node.value_exact<std::string>()) return *value;
  const toml::array* array = node.as_array();
  if (!array || array->is_homogeneous(toml::node_type::table)) return {};
  if (const auto points = points_of(*array); points) return *points;
  if (const auto numbers = numbers_of(*array)) return *numbers;
  if (const auto rows = rows_of(*array)) return *rows;
  return {};
}

void read_list(const List& list, const toml::node& node, const Placing& place, Settings& out) {
  const toml::array* array = node.as_array();
  if (!array || !(array->empty() || array->is_homogeneous(toml::node_type::table)))
    return complain(place(node.source()),
                    fmt::format("{} is a list: write {} above the keys of each, or {} = {}", dotted(list), title(list),
                                list.key, form(list)),
                    out);
  ListSetting setting{&list, {}};
  for (const toml::node& table : *array) setting.tables.push_back(read_table(list, *table.as_table(), place, out));
  out.lists.push_back(std::move(setting));
}

void read_list_text(const List& list, const std::string& text, const std::string& origin, Settings& out) {
  const Place place{origin, {}};
  const auto at_origin = [&](const toml::source_region&) -> const Place& { return place; };
  try {
    const toml::table root = toml::parse("list = " + text);
    if (root.size() > 1) return complain(place, fmt::format("expected one list, as in {}", form(list)), out);
    read_list(list, *root.get("list"), at_origin, out);
  } catch (const toml::parse_error& error) {
    complain(place, fmt::format("{}; expected a list as in {}", error.description(), form(list)), out);
  }
}

}  // namespace seiche::apps
