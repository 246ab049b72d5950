#include "apps/scene/toml_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "apps/common/nearest.hpp"
#include "apps/scene/toml_lists.hpp"

namespace seiche::apps {
namespace {

Place place(const std::string& file, const toml::source_position& at) {
  return {fmt::format("{}:{}:{}", file, at.line, at.column), {at.line, at.column}};
}

// The nearest right name for a key that the table doesn't have, as the end of a sentence.
std::string key_hint(const std::string& section, const std::string& key) {
  std::vector<std::string> here;
  for (const Option& option : options()) {
    if (option.section == section) here.emplace_back(option.key);
  }
  for (const List& list : lists()) {
    if (list.section == section) here.emplace_back(list.key);
  }
  if (const auto guess = nearest(key, here)) return fmt::format("; did you mean '{}'?", *guess);
  for (const Option& option : options()) {
    if (option.key != key) continue;
    return option.section.empty() ? fmt::format("; '{}' stands above the first [section]", key)
                                  : fmt::format("; it belongs under [{}]", option.section);
  }
  for (const List& list : lists()) {
    if (list.key == key) return fmt::format("; it belongs under [{}], as {}", list.section, title(list));
  }
  return fmt::format("; expected one of {}", fmt::join(here, ", "));
}

std::string section_hint(const std::string& section) {
  std::vector<std::string> names = sections();
  names.erase(names.begin());
  if (const auto guess = nearest(section, names)) return fmt::format("; did you mean [{}]?", *guess);
  return fmt::format("; expected one of [{}]", fmt::join(names, "], ["));
}

class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {}

  Settings read(const toml::table& root) {
    const std::vector<std::string> names = sections();
    for (const auto& [key, node] : root) {
      const std::string name(key.str());
      const bool known = !name.empty() && std::find(names.begin(), names.end(), name) != names.end();
      if (known && node.is_table()) {
        for (const auto& [inner, value] : *node.as_table()) read_key(name, inner, value);
      } else if (known) {
        complain(key, fmt::format("'{0}' is a section: write [{0}] on a line of its own, above its keys", name));
      } else if (node.is_table() || node.is_array_of_tables()) {
        complain(key, fmt::format("unknown section [{}]{}", name, section_hint(name)));
      } else {
        read_key("", key, node);
      }
    }
    return std::move(result_);
  }

 private:
  void read_key(const std::string& section, const toml::key& key, const toml::node& node) {
    const std::string name(key.str());
    if (const List* list = find_list(section, name)) {
      return read_list(
          *list, node, [&](const auto& source) { return place(file_, source.begin); }, result_);
    }
    const Option* option = find_option(section, name);
    if (!option) {
      const std::string shown = section.empty() ? name : fmt::format("[{}] {}", section, name);
      return complain(key, fmt::format("unknown key {}{}", shown, key_hint(section, name)));
    }
    const auto value = value_of_node(node);
    if (!value) return complain(key, fmt::format("{} takes one value; expected {}", title(*option), expected(*option)));
    const Place at = place(file_, node.source().begin);
    result_.good.push_back({at.origin, at.position, option, *value});
  }

  void complain(const toml::key& key, const std::string& message) {
    const Place at = place(file_, key.source().begin);
    result_.complaints.push_back({fmt::format("{}: {}", at.origin, message), at.position});
  }

  std::string file_;
  Settings result_;
};

}  // namespace

Settings toml_settings(const std::string& toml, const std::string& file) {
  try {
    return Reader(file).read(toml::parse(toml));
  } catch (const toml::parse_error& error) {
    const Place at = place(file, error.source().begin);
    return {{}, {}, {{fmt::format("{}: {}", at.origin, error.description()), at.position}}};
  }
}

}  // namespace seiche::apps
