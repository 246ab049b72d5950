#include "apps/common/schema.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "tests/facts.hpp"

namespace seiche::apps {
namespace {

std::string refusal_of(const std::string& json) {
  try {
    check_schema(nlohmann::json::parse(json), 2, "run it again");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Schema, IsTheOneExpected) {
  EXPECT_EQ(refusal_of(R"({"schema": 2, "more": 3})"), "");
  EXPECT_TRUE(test::tells(refusal_of(R"({"schema": 3})"), {"3", "2"}));
  EXPECT_TRUE(test::tells(refusal_of(R"({"schema": "x"})"), {"\"x\"", "2"}));
}

TEST(Schema, ThatIsMissingTellsAnOldProgram) {
  for (const char* json : {R"({"seiche": "0.1.0"})", "[]"})
    EXPECT_TRUE(test::tells(refusal_of(json), {"no schema version", "0.1", "version 2", "run it again"}));
}

}  // namespace
}  // namespace seiche::apps
