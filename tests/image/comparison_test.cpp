#include <gtest/gtest.h>

#include "tests/image/baseline.hpp"
#include "tests/image/ssim.hpp"
#include "tests/unit/render/synthetic_comparison.hpp"

// Pictures of several runs.
using namespace seiche;
using namespace seiche::render;
using test::sized;

namespace {

const test::Box tank{.spacing = 0.02};

Look with_reference(int width, int height) {
  Look look = sized(width, height);
  look.references = {test::reference()};
  look.references[0].label = "theory";
  return look;
}

}  // namespace

TEST(ComparisonBaseline, FiveWithOneThatFailed) {
  test::expect_baseline("comparison-large", test::draw_comparison(with_reference(1280, 720), tank, 5, 6.24));
}

TEST(ComparisonBaseline, FiveSmall) {
  test::expect_baseline("comparison-small", test::draw_comparison(with_reference(640, 360), tank, 5, 6.24));
}

TEST(ComparisonBaseline, NineOnBlack) {
  Look look = sized(1280, 720);
  look.background = Background::black;
  test::expect_baseline("comparison-black", test::draw_comparison(look, tank, 9, 0.9));
}

TEST(ComparisonBaseline, SeesThatThePanelIsDimmed) {
  const Look look = with_reference(640, 360);
  EXPECT_LT(test::similarity(test::draw_comparison(look, tank, 2, test::failure),
                             test::draw_comparison(look, tank, 2, test::failure + 0.02))
                .least,
            test::least_tile);
}
