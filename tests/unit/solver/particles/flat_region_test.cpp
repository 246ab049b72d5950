#include "solver/particles/flat_region.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

void expect_rim(const FlatRegion& region, const Vec<2>& at, double distance, const Vec<2>& foot) {
  const FlatRegion::Rim rim = region.rim(at);
  EXPECT_NEAR(rim.distance, distance, 1e-12) << at.transpose();
  EXPECT_LT((rim.foot - foot).norm(), 1e-12) << at.transpose();
}

TEST(FlatRegion, ARectanglesRim) {
  const FlatRegion region{{2, 1}, 0, {}};
  expect_rim(region, {0.5, 0.2}, -0.8, {0.5, 1});
  expect_rim(region, {-1.9, 0.2}, -0.1, {-2, 0.2});
  expect_rim(region, {3, 0.2}, 1, {2, 0.2});
  expect_rim(region, {2.3, -1.4}, 0.5, {2, -1});
}

TEST(FlatRegion, ADiscsRim) {
  const FlatRegion region{{0, 0}, 2, {}};
  EXPECT_NEAR(region.rim({0, 0}).distance, -2, 1e-12);
  expect_rim(region, {0.6, -0.8}, -1, {1.2, -1.6});
  expect_rim(region, {0, 5}, 3, {0, 2});
}

TEST(FlatRegion, ARingsRimsAndThoseOfHoles) {
  const FlatRegion ring{{0, 0}, 2, {{{0, 0}, 1}}};
  expect_rim(ring, {1.4, 0}, -0.4, {1, 0});
  expect_rim(ring, {1.7, 0}, -0.3, {2, 0});
  expect_rim(ring, {0.2, 0}, 0.8, {1, 0});
  expect_rim(ring, {0, 2.5}, 0.5, {0, 2});
  const FlatRegion holed{{2, 1}, 0, {{{1, 0}, 0.5}, {{-1, 0}, 0.25}}};
  expect_rim(holed, {1, 0.3}, 0.2, {1, 0.5});
  expect_rim(holed, {-0.6, 0}, -0.15, {-0.75, 0});
  expect_rim(holed, {0, 0.9}, -0.1, {0, 1});
}

}  // namespace
}  // namespace seiche::solver
