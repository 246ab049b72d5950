#include "apps/toml_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>

#include "apps/nearest.hpp"

namespace seiche::apps {
namespace {

std::string where(const std::string& file, const toml::source_position& at) {
  return fmt::format("{}:{}:{}", file, at.line, at.column);
}

// The nearest right name for a key that the table doesn't have, as the end of a sentence.
std::string key_hint(const std::string& section, const std::string& key) {
  std::vector<std::string> here;
  for (const Option& option : options()) {
    if (option.section == section) here.emplace_back(option.key);
  }
  if (const auto guess = nearest(key, here)) return fmt::format("; did you mean '{}'?", *guess);
  for (const Option& option : options()) {
    if (option.key != key) continue;
    return option.section.empty() ? fmt::format("; '{}' stands above the first [section]", key)
                                  : fmt::format("; it belongs under [{}]", option.section);
  }
  return fmt::format("; expected one of {}", fmt::join(here, ", "));
}

std::string section_hint(const std::string& section) {
  std::vector<std::string> names = sections();
  names.erase(names.begin());
  if (const auto guess = nearest(section, names)) return fmt::format("; did you mean [{}]?", *guess);
  return fmt::format("; expected one of [{}]", fmt::join(names, "], ["));
}

std::optional<Value> value_of_node(const toml::node& node) {
  if (const auto value = node.value_exact<bool>()) return *value;
  if (const auto value = node.value_exact<std::int64_t>()) return *value;
  if (const auto value = node.value_exact<double>()) return *value;
  if (const auto value = node.value_exact<std::string>()) return *value;
  return {};  // A date, an array or a table: no key takes one.
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
      } else if (node.is_table()) {
        complain(key, fmt::format("[{}] is no section of a scene{}", name, section_hint(name)));
      } else {
        read_key("", key, node);
      }
    }
    return std::move(result_);
  }

 private:
  void read_key(const std::string& section, const toml::key& key, const toml::node& node) {
    const std::string name(key.str());
    const Option* option = find_option(section, name);
    if (!option) {
      const std::string shown = section.empty() ? name : fmt::format("[{}] {}", section, name);
      return complain(key, fmt::format("{} is no key of a scene{}", shown, key_hint(section, name)));
    }
    const auto value = value_of_node(node);
    if (!value) return complain(key, fmt::format("{} takes one value; expected {}", title(*option), expected(*option)));
    const toml::source_position at = node.source().begin;
    result_.good.push_back({where(file_, at), {at.line, at.column}, option, *value});
  }

  void complain(const toml::key& key, const std::string& message) {
    const toml::source_position at = key.source().begin;
    result_.complaints.push_back({fmt::format("{}: {}", where(file_, at), message), {at.line, at.column}});
  }

  std::string file_;
  Settings result_;
};

}  // namespace

Settings toml_settings(const std::string& toml, const std::string& file) {
  try {
    return Reader(file).read(toml::parse(toml));
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    return {{}, {{fmt::format("{}: {}", where(file, at), error.description()), {at.line, at.column}}}};
  }
}

}  // namespace seiche::apps
