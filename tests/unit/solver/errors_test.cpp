#include "solver/errors.hpp"

#include <gtest/gtest.h>

namespace seiche {
namespace {

TEST(RunFailure, SaysWhenWhyAndWhere) {
  const Failure failure{0.019, 36, "the speed is beyond the limit", {}, Failure::Particle{Kind::fluid, 550, {0.1, 2}}};
  const std::string cause = "the speed is beyond the limit (fluid particle 550 at x = 0.1 m, y = 2 m)";
  EXPECT_EQ(cause_text(failure), cause);
  EXPECT_STREQ(RunFailure(failure).what(), ("stopped at t = 0.0190 s, step 36: " + cause).c_str());
  const RunFailure thrown(failure);
  ASSERT_TRUE(thrown.failure.place);
  EXPECT_EQ(thrown.failure.place->id, 550u);
}

TEST(RunFailure, NeedsNeitherDetailNorPlace) {
  EXPECT_EQ(sentence({1, 2, "it leaks"}), "stopped at t = 1.0000 s, step 2: it leaks");
  EXPECT_EQ(cause_text({1, 2, "it leaks", "more than 5 %"}), "it leaks (more than 5 %)");
  EXPECT_EQ(cause_text({1, 2, "it leaks", {}, Failure::Particle{Kind::dummy, 3, {1, 2, 3}}}),
            "it leaks (dummy particle 3 at x = 1 m, y = 2 m, z = 3 m)");
}

}  // namespace
}  // namespace seiche
