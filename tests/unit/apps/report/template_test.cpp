#include "apps/report/template.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace seiche::apps::report {
namespace {

TEST(Template, PutsInWhatNamesStandFor) {
  EXPECT_EQ(filled("<p>{{a}}, {{b}}{{a}}</p> { } {{", {{"a", "1"}, {"b", ""}}), "<p>1, 1</p> { } {{");
  EXPECT_EQ(filled("", {}), "");
}

TEST(Template, DoesNotSearchWhatItPutsIn) { EXPECT_EQ(filled("{{a}}", {{"a", "{{b}}"}, {"b", "2"}}), "{{b}}"); }

TEST(Template, RefusesANameThatStandsForNothing) { EXPECT_THROW(filled("{{c}}", {{"a", "1"}}), std::logic_error); }

}  // namespace
}  // namespace seiche::apps::report
