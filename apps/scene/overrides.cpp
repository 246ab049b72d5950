#include "apps/scene/overrides.hpp"

#include <fmt/format.h>

#include <charconv>

#include "apps/common/nearest.hpp"
#include "apps/scene/toml_lists.hpp"

namespace seiche::apps {
namespace {

template <class Entry>
const Entry* find_dotted(const std::vector<Entry>& table, const std::string& key) {
  for (const Entry& entry : table) {
    if (dotted(entry) == key) return &entry;
  }
  return nullptr;
}

std::string hint(const std::string& key) {
  std::vector<std::string> all;
  for (const Option& option : options()) {
    if (option.key == key) return fmt::format("did you mean '{}'?", dotted(option));
    all.push_back(dotted(option));
  }
  for (const List& list : lists()) {
    if (list.key == key) return fmt::format("did you mean '{}'?", dotted(list));
    all.push_back(dotted(list));
  }
  if (const auto guess = nearest(key, all)) return fmt::format("did you mean '{}'?", *guess);
  for (const Option& option : options()) {
    if (nearest(key, {std::string(option.key)})) return fmt::format("did you mean '{}'?", dotted(option));
  }
  return "`seiche run SCENE --dry-run` shows every key";
}

// Text where the key takes text, else what the value looks like.
Value read_value(const Option& option, const std::string& text) {
  if (std::holds_alternative<bool& (*)(Scene&)>(option.access)) {
    return text == "true" || text == "false" ? Value(text == "true") : Value(text);
  }
  if (std::holds_alternative<OneOr>(option.rule) || std::holds_alternative<Pairs>(option.rule))
    return value_of_text(text).value_or(text);
  if (!std::holds_alternative<Range>(option.rule)) return text;
  const char *begin = text.data(), *end = begin + text.size();
  std::int64_t whole = 0;
  if (const auto [last, error] = std::from_chars(begin, end, whole); error == std::errc{} && last == end) return whole;
  double real = 0;
  if (const auto [last, error] = std::from_chars(begin, end, real); error == std::errc{} && last == end) return real;
  return text;
}

}  // namespace

Override parse_set(const std::string& text) {
  const std::size_t equals = text.find('=');
  const std::string value = equals == std::string::npos ? "" : text.substr(equals + 1);
  return {"--set " + text, text.substr(0, equals), value};
}

Settings override_settings(const std::vector<Override>& overrides) {
  Settings result;
  for (const Override& each : overrides) {
    if (const Option* option = find_dotted(options(), each.key)) {
      result.good.push_back({each.origin, {}, option, read_value(*option, each.value)});
    } else if (const List* list = find_dotted(lists(), each.key)) {
      read_list_text(*list, each.value, each.origin, result);
    } else {
      const std::string message = fmt::format("{}: unknown key '{}'; {}", each.origin, each.key, hint(each.key));
      result.complaints.push_back({message, {}});
    }
  }
  return result;
}

}  // namespace seiche::apps
