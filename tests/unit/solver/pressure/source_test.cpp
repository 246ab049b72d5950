#include "solver/pressure/source.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

TEST(Source, OfTheDensityIsEquation10) {
  Parameters p;
  p.fluid.density = 800;
  const DensitySource source(p);
  EXPECT_DOUBLE_EQ(source(0.05, 0.01), 800 * 0.05 / 1e-4);
  EXPECT_DOUBLE_EQ(source(-0.05, 0.01), -800 * 0.05 / 1e-4);
}

// The rate of the density term is 0.1 sqrt(g H)/l0: with sqrt(g H) = 2 m/s and l0 = 0.01 m it is 20 per second.
MixedSource mixed() {
  Parameters p;
  p.fluid.density = 800;
  p.particles.spacing = 0.01;
  return MixedSource(p, 2);
}

TEST(Source, MixedAddsAShareOfTheDensityToTheDivergence) {
  EXPECT_DOUBLE_EQ(mixed()(7, 0, false, 0.01), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(mixed()(0, 0.05, false, 0.01), 800 * 20 * 0.05 / 0.01);
  EXPECT_DOUBLE_EQ(mixed()(7, -0.05, false, 0.01), 800 * (-7 - 20 * 0.05) / 0.01);
}

TEST(Source, MixedKeepsTheBalanceOfItsTermsWhenTheStepChanges) {
  for (const double dt : {0.01, 0.003, 1e-5}) EXPECT_NEAR(mixed()(20 * 0.05, 0.05, false, dt), 0, 1e-9 / dt);
}

TEST(Source, MixedDropsALackOfNeighboursNearTheSurface) {
  EXPECT_DOUBLE_EQ(mixed()(7, -0.05, true, 0.01), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(mixed()(0, 0.05, true, 0.01), 800 * 20 * 0.05 / 0.01) << "too many still count";
}

TEST(Source, IsTheOneThatTheSceneNames) {
  Parameters p;
  p.method.source = SourceTerm::density;
  EXPECT_TRUE(std::holds_alternative<DensitySource>(make_source(p, 2)));
  p.method.source = SourceTerm::mixed;
  EXPECT_TRUE(std::holds_alternative<MixedSource>(make_source(p, 2)));
}

}  // namespace
}  // namespace seiche::solver
