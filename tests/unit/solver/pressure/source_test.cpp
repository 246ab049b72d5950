#include "solver/pressure/source.hpp"

#include <gtest/gtest.h>

namespace seiche::solver {
namespace {

Source of_the_density() {
  Parameters p;
  p.method.source = SourceTerm::density;
  p.fluid.density = 800;
  return Source(p, 0.01);
}

TEST(Source, OfTheDensityIsEquation10) {
  const Source density = of_the_density();
  EXPECT_DOUBLE_EQ(density(7, 0.05, false), 800 * 0.05 / 1e-4);
  EXPECT_DOUBLE_EQ(density(7, -0.05, true), -800 * 0.05 / 1e-4) << "the divergence and the surface don't matter";
}

// The rate of the density term is 0.1 sqrt(g H)/l0: with g H = 4 m^2/s^2 and l0 = 0.01 m it is 20 per second.
Source mixed(double dt) {
  Parameters p;
  p.method.source = SourceTerm::mixed;
  p.fluid.density = 800;
  p.gravity = 8;
  p.fluid.depth = 0.5;
  p.particles.spacing = 0.01;
  return Source(p, dt);
}

TEST(Source, MixedAddsAShareOfTheDensityToTheDivergence) {
  EXPECT_DOUBLE_EQ(mixed(0.01)(7, 0, false), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(mixed(0.01)(0, 0.05, false), 800 * 20 * 0.05 / 0.01);
  EXPECT_DOUBLE_EQ(mixed(0.01)(7, -0.05, false), 800 * (-7 - 20 * 0.05) / 0.01);
}

TEST(Source, MixedKeepsTheBalanceOfItsTermsWhenTheStepChanges) {
  for (const double dt : {0.01, 0.003, 1e-5}) EXPECT_NEAR(mixed(dt)(20 * 0.05, 0.05, false), 0, 1e-9 / dt);
}

TEST(Source, MixedDropsALackOfNeighboursNearTheSurface) {
  EXPECT_DOUBLE_EQ(mixed(0.01)(7, -0.05, true), -800 * 7 / 0.01);
  EXPECT_DOUBLE_EQ(mixed(0.01)(0, 0.05, true), 800 * 20 * 0.05 / 0.01) << "too many still count";
}

}  // namespace
}  // namespace seiche::solver
