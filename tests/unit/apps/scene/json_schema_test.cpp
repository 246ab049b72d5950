#include "apps/scene/json_schema.hpp"

#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "apps/scene/lists.hpp"
#include "apps/scene/options.hpp"

namespace seiche::apps {
namespace {

using nlohmann::json;

json properties_of(const json& schema, std::string_view section) {
  const json& all = schema.at("properties");
  return section.empty() ? all : all.at(std::string(section)).at("properties");
}

TEST(JsonSchema, HasEachKeyWithItsTypeDefaultAndRange) {
  const json schema = json::parse(scene_json_schema());
  EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
  for (const Option& option : options()) {
    const json properties = properties_of(schema, option.section);
    ASSERT_TRUE(properties.contains(option.key)) << dotted(option);
    const json& key = properties.at(std::string(option.key));
    EXPECT_TRUE((key.contains("type") || key.contains("oneOf")) && key.contains("default")) << dotted(option);
    EXPECT_NE(key.at("description").get<std::string>().find(option.help), std::string::npos) << dotted(option);
    if (std::holds_alternative<Range>(option.rule)) {
      EXPECT_TRUE(key.contains("maximum")) << dotted(option);
    }
    if (const auto* choices = std::get_if<Choices>(&option.rule)) {
      EXPECT_EQ(key.at("enum").size(), choices->size()) << dotted(option);
    }
  }
}

TEST(JsonSchema, HasEachKeyOfEachListAndWhichAreRequired) {
  const json schema = json::parse(scene_json_schema());
  for (const List& list : lists()) {
    const json table = properties_of(schema, list.section).at(std::string(list.key)).at("items");
    for (const Member& member : list.members) {
      EXPECT_TRUE(table.at("properties").contains(member.key)) << title(list, member);
      const json required = table.value("required", json::array());
      EXPECT_EQ(std::count(required.begin(), required.end(), member.key), member.required) << title(list, member);
    }
  }
}

TEST(JsonSchema, SaysWhatARangeAChoiceAndAWholeNumberAre) {
  const json schema = json::parse(scene_json_schema());
  const json density = properties_of(schema, "fluid").at("density");
  EXPECT_EQ(density.at("type"), "number");
  EXPECT_EQ(density.at("exclusiveMinimum"), 0);
  EXPECT_EQ(density.at("x-unit"), "kg/m^3");
  EXPECT_EQ(properties_of(schema, "fluid").at("wave_mode").at("type"), "integer");
  EXPECT_EQ(properties_of(schema, "").at("preset").at("enum"), json({"stabilised", "paper"}));
  EXPECT_EQ(schema.at("additionalProperties"), false);
}

// Complains of each key of the table that the schema hasn't.
void expect_known(const toml::table& table, const json& schema, const std::string& where) {
  for (const auto& [key, node] : table) {
    const std::string name(key.str());
    ASSERT_TRUE(schema.at("properties").contains(name)) << where << ": " << name;
    std::string place = where;
    place.append(": ").append(name);
    const json& known = schema.at("properties").at(name);
    if (const toml::table* section = node.as_table()) expect_known(*section, known, place);
    if (const toml::array* rows = node.as_array())
      for (const toml::node& row : *rows)
        if (const toml::table* keys = row.as_table()) expect_known(*keys, known.at("items"), place);
  }
}

TEST(JsonSchema, KnowsAllThatTheScenesHold) {
  const json schema = json::parse(scene_json_schema());
  int scenes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SEICHE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".toml") continue;
    expect_known(toml::parse_file(entry.path().string()), schema, entry.path().string());
    ++scenes;
  }
  EXPECT_GT(scenes, 5);
}

}  // namespace
}  // namespace seiche::apps
