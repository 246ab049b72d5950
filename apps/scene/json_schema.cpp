#include "apps/scene/json_schema.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"
#include "solver/column.hpp"

namespace seiche::apps {
namespace {

using Json = nlohmann::ordered_json;  // keys in the order of the tables

const char* type_of(const Value& value) {
  constexpr const char* names[] = {"boolean", "integer", "number", "string",
                                   "array",   "array",   "array"};  // as Value has them
  return names[value.index()];
}

void add_range(Json& schema, const Range& range) {
  schema[range.above_low ? "exclusiveMinimum" : "minimum"] = range.low;
  schema["maximum"] = range.high;
}

Json number_in(const Range& range) {
  Json schema{{"type", "number"}};
  add_range(schema, range);
  return schema;
}

Json array_of(const Json& item, std::size_t count) {
  return {{"type", "array"}, {"items", item}, {"minItems", count}, {"maxItems", count}};
}

// A key of a section or of a list's tables.
template <class Key>
Json key_schema(const Key& key, const Value& value) {
  Json schema{{"type", type_of(value)}};
  schema["description"] = fmt::format("{}{}{}", key.help, key.help.empty() ? "" : ": ", explained(key));
  if (!key.unit.empty()) schema["x-unit"] = key.unit;
  if (const auto* range = std::get_if<Range>(&key.rule)) add_range(schema, *range);
  if (const auto* rule = std::get_if<OneOr>(&key.rule)) {
    schema.erase("type");
    schema["oneOf"] = {number_in(rule->range), array_of(number_in(rule->range), rule->count)};
  }
  if (const auto* rule = std::get_if<Pairs>(&key.rule)) schema["items"] = array_of(number_in(rule->range), 2);
  if (const auto* rule = std::get_if<Tuple>(&key.rule)) schema.update(array_of(number_in(rule->range), rule->count));
  if (const auto* rule = std::get_if<Tuples>(&key.rule))
    schema["items"] = array_of(number_in(rule->range), rule->count);
  if (const auto* choices = std::get_if<Choices>(&key.rule)) schema["enum"] = *choices;
  if (std::holds_alternative<Name>(key.rule)) schema["pattern"] = column_name_pattern;
  std::visit([&](const auto& plain) { schema["default"] = plain; }, value);
  return schema;
}

Json object() { return {{"type", "object"}, {"properties", Json::object()}, {"additionalProperties", false}}; }

Json list_schema(const List& list) {
  Scene example;
  list.reset(example, 1);
  Json table = object();
  for (const Member& member : list.members) {
    Json& schema = table["properties"][std::string(member.key)];
    schema = key_schema(member, value_of(member, example, 0));
    if (!member.required) continue;
    schema.erase("default");
    table["required"].push_back(member.key);
  }
  return {{"type", "array"}, {"description", list.help}, {"items", table}};
}

// The properties of a section, which is made where it is missing.
Json& properties(Json& root, std::string_view section) {
  if (section.empty()) return root["properties"];
  Json& place = root["properties"][std::string(section)];
  if (place.is_null()) place = object();
  return place["properties"];
}

}  // namespace

std::string scene_json_schema() {
  Json root{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "A scene of Seiche"}};
  root.update(object());
  const Scene scene;
  for (const Option& option : options())
    properties(root, option.section)[std::string(option.key)] = key_schema(option, value_of(option, scene));
  for (const List& list : lists()) properties(root, list.section)[std::string(list.key)] = list_schema(list);
  return root.dump(2) + "\n";
}

}  // namespace seiche::apps
