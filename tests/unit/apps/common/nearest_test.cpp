#include "apps/common/nearest.hpp"

#include <gtest/gtest.h>

namespace seiche::apps {
namespace {

TEST(EditDistance, CountsEachSlip) {
  EXPECT_EQ(edit_distance("depth", "depth"), 0);
  EXPECT_EQ(edit_distance("depth", "dpth"), 1);    // left out
  EXPECT_EQ(edit_distance("depth", "deepth"), 1);  // put in
  EXPECT_EQ(edit_distance("depth", "dipth"), 1);   // replaced
  EXPECT_EQ(edit_distance("depth", "detph"), 1);   // swapped
  EXPECT_EQ(edit_distance("", "depth"), 5);
}

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> keys{"type", "amplitude", "frequency", "start"};
  EXPECT_EQ(nearest("amplitde", keys), "amplitude");
  EXPECT_EQ(nearest("freqency", keys), "frequency");
  EXPECT_EQ(nearest("Type", keys), "type");
}

TEST(Nearest, SaysNothingWhenNothingIsNear) { EXPECT_EQ(nearest("viscosity", {"type", "start"}), std::nullopt); }

TEST(Nearest, SaysNothingWhenSeveralAreEquallyNear) { EXPECT_EQ(nearest("KF6", {"KF1", "KF2"}), std::nullopt); }

}  // namespace
}  // namespace seiche::apps
