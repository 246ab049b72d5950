#include "solver/tank/facets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solver/tank/shapes/built_in.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

template <int D>
struct Integrals {
  double area = 0, volume = 0;
  Vec<D> closed = Vec<D>::Zero();  ///< of n, 0 over a closed surface

  explicit Integrals(const std::vector<Facet<D>>& facets) {
    for (const auto& facet : facets)
      for (const auto& [offset, share] : facet.points) {
        area += share.norm();
        volume += (facet.centre + offset).dot(share) / D;
        closed += share;
      }
  }
};

TEST(Facets, CoverABoxInSquaresOfItsLattice) {
  const auto facets = facets_of<2>(wall_surface(test::small_tank<2>()), test::l0);
  EXPECT_EQ(facets.size(), 70u);
  const Integrals<2> all(facets);
  EXPECT_NEAR(all.area, 0.7, 1e-14);
  EXPECT_NEAR(all.volume, 0.03, 1e-15);
  EXPECT_LT(all.closed.norm(), 1e-15);
  const auto in_3d = facets_of<3>(wall_surface(test::small_tank<3>()), test::l0);
  const Integrals<3> body(in_3d);
  EXPECT_NEAR(body.area, 2 * (0.2 * 0.15 + 0.2 * 0.12 + 0.15 * 0.12), 1e-13);
  EXPECT_NEAR(body.volume, 0.2 * 0.15 * 0.12, 1e-14);
}

TEST(Facets, CoverASphereInPiecesAsLargeAsParticles) {
  const double l0 = 0.025;
  const auto facets = facets_of<3>(sphere(0.25).surface(), l0);
  const Integrals<3> all(facets);
  EXPECT_NEAR(all.area, std::numbers::pi * 0.25, 2e-4);
  EXPECT_NEAR(all.volume, 4. / 3 * std::numbers::pi * std::pow(0.25, 3), 2e-4 * all.volume);
  EXPECT_LT(all.closed.norm(), 1e-12);
  EXPECT_LT(static_cast<double>(facets.size()), 3 * all.area / (l0 * l0));
  for (const auto& facet : facets)
    for (const auto& point : facet.points) EXPECT_LT(point.offset.cwiseAbs().maxCoeff(), 1.5 * l0);
}

TEST(Facets, OfAPlateFaceOneSideEach) {
  // The plate lies within the cubes of one column.
  SurfaceMesh mesh{{{0, 0, 0}, {0.013, 0, 0}, {0.013, 0.05, 0}}, {{"floor", {{0, 1}}}, {"baffle", {{1, 2}, {2, 1}}}}};
  double area = 0;
  for (const auto& facet : facets_of<2>(mesh, 0.05))
    for (const auto& point : facet.points) {
      EXPECT_GT(point.area.dot(facet.points.front().area), 0);
      area += point.area.norm();
    }
  EXPECT_NEAR(area, 0.113, 1e-12);
}

}  // namespace
}  // namespace seiche::solver
