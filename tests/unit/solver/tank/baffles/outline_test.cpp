#include "solver/tank/baffles/outline.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/facts.hpp"

namespace seiche::solver {
namespace {

std::string refusal_of(const BaffleLine& baffle) {
  try {
    outline_of(baffle);
  } catch (const BadParameters& error) {
    return error.what();
  }
  return "taken";
}

void expect_points(const std::vector<Vec<2>>& points, const std::vector<Vec<2>>& expected) {
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_LT((points[k] - expected[k]).norm(), 1e-12) << k;
}

TEST(BaffleOutline, OfAPlateGoesThereAndBack) {
  expect_points(outline_of({{{0, 0}, {1, 0}, {1, 2}}, 0}), {{0, 0}, {1, 0}, {1, 2}, {1, 0}});
}

TEST(BaffleOutline, OfAThickOneGoesRoundIt) {
  expect_points(outline_of({{{0, 0}, {0, 1}}, 0.2}), {{0.1, 0}, {0.1, 1}, {-0.1, 1}, {-0.1, 0}});
  // The bend is mitred.
  expect_points(outline_of({{{0, 0}, {1, 0}, {1, 2}}, 0.2}),
                {{0, -0.1}, {1.1, -0.1}, {1.1, 2}, {0.9, 2}, {0.9, 0.1}, {0, 0.1}});
}

TEST(BaffleOutline, ALineThatIsNoneIsRefused) {
  EXPECT_TRUE(test::tells(refusal_of({{{0, 0}}, 0}), {"two points", "points = "}));
  EXPECT_TRUE(test::tells(refusal_of({{{0.5, 1}, {0.5, 1}}, 0}), {"two points", "(0.5, 1) m"}));
  EXPECT_TRUE(
      test::tells(refusal_of({{{0, 0}, {1, 0}, {0, 0.1}}, 0.5}), {"0.5 m thick", "(1, 0) m", "less thickness"}));
  EXPECT_EQ(refusal_of({{{0, 0}, {1, 0}, {0, 0.1}}, 0}), "taken") << "a plate may turn back";
}

TEST(BaffleOutline, TellsWhereALineCrossesIt) {
  const auto square = outline_of({{{0, 0}, {0, 1}}, 0.2});
  const auto shares = crossings_of({-1, 0.5}, {1, 0.5}, square);
  ASSERT_EQ(shares.size(), 2u);
  EXPECT_NEAR(shares[0], 0.45, 1e-12);
  EXPECT_NEAR(shares[1], 0.55, 1e-12);
  EXPECT_TRUE(crossings_of({-1, 2}, {1, 2}, square).empty());
}

}  // namespace
}  // namespace seiche::solver
