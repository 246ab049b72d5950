#include "solver/source.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

Source source(const std::string& name) {
  Parameters p;
  p.method.source = name;
  p.fluid.density = 800;
  return Source(p, 0.01);
}

TEST(Source, OfTheDensityIsEquation10) {
  const Source density = source("density");
  EXPECT_DOUBLE_EQ(density(7, 0.05, false), 800 * 0.05 / 1e-4);
  EXPECT_DOUBLE_EQ(density(7, -0.05, true), -800 * 0.05 / 1e-4) << "the divergence and the surface don't matter";
}

TEST(Source, MixedAddsAShareOfTheDensityToTheDivergence) {
  EXPECT_DOUBLE_EQ(source("mixed")(7, 0, false), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(source("mixed")(0, 0.05, false), 0.02 * 800 * 0.05 / 1e-4);
  EXPECT_DOUBLE_EQ(source("mixed")(7, -0.05, false), -800 * 7 / 0.01 - 0.02 * 800 * 0.05 / 1e-4);
}

TEST(Source, MixedDropsALackOfNeighboursNearTheSurface) {
  EXPECT_DOUBLE_EQ(source("mixed")(7, -0.05, true), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(source("mixed")(0, 0.05, true), 0.02 * 800 * 0.05 / 1e-4) << "too many still count";
}

}  // namespace
}  // namespace seiche::solver
