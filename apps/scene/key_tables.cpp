#include "apps/scene/key_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"

namespace seiche::apps {
namespace {

constexpr std::string_view header = "| key | default | takes | is |\n|---|---|---|---|\n";

// Within a cell of a table.
std::string cell(std::string text) {
  for (std::size_t at = 0; (at = text.find_first_of("|<*_[", at)) != std::string::npos; at += 2)
    text.insert(at, 1, '\\');
  return text;
}

std::string shown(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("`\"{}\"`", *text);
  return std::visit([](const auto& plain) { return fmt::format("`{}`", plain); }, value);
}

template <class Key>
std::string row(const Key& key, const std::string& value) {
  return fmt::format("| `{}` | {} | {} | {} |\n", key.key, value, cell(explained(key)), cell(std::string(key.help)));
}

std::string list_table(const List& list) {
  Scene example;
  list.reset(example, 1);
  std::string result = fmt::format("\n### `{}`\n\n{}\n\n{}", title(list), cell(std::string(list.help)), header);
  for (const Member& member : list.members)
    result += row(member, member.required ? "required" : is_of_row(member) ? "" : shown(value_of(member, example, 0)));
  return result;
}

}  // namespace

std::string key_tables() {
  std::string result;
  const Scene scene;
  for (const std::string& section : sections()) {
    result += section.empty() ? "### Above the first section\n\n" : fmt::format("\n### `[{}]`\n\n", section);
    result += header;
    for (const Option& option : options())
      if (option.section == section) result += row(option, shown(value_of(option, scene)));
    for (const List& list : lists())
      if (list.section == section) result += list_table(list);
  }
  return result;
}

}  // namespace seiche::apps
