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
  const std::string missing = "it has no schema version, as those of Seiche 0.1; expected version 2; run it again";
  EXPECT_EQ(refusal_of(R"({"seiche": "0.1.0"})"), missing);
  EXPECT_EQ(refusal_of("[]"), missing);
}

}  // namespace
}  // namespace seiche::apps
