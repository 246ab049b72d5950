#include <gtest/gtest.h>

#include "solver/operators/close_pairs.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

/// A wall through the origin, square to an axis, the tank on its positive side.
template <int D>
struct Plane {
  int axis = 1;

  struct Seen {
    double distance;
    Vec<D> normal;
  };
  Seen operator()(const Vec<D>& r) const { return {-r[axis], -Vec<D>::Unit(axis)}; }
};

template <int D>
void collide(State<D>& s, const Plane<D>& wall = {}, std::uint8_t near_surface = 0) {
  const auto list = test::listed(s, 2 * l0);
  Collisions<D> buffers;
  const std::vector<std::uint8_t> near(s.size(), near_surface);
  collide_close_pairs(0.8 * l0, l0, near, list, s, buffers);
  collide_with_walls(0.8 * l0, l0, near, buffers.at_wall, wall, list, s);
}

/// Two particles `apart` along x, the second with velocity `u`, after their collision, in the order of their making.
template <int D>
State<D> pair(double apart, const Vec<D>& u, Kind first = Kind::fluid, std::uint8_t near_surface = 0) {
  State<D> s;
  s.add(Vec<D>::Zero(), first, Vec<D>::Zero());
  s.add(apart * Vec<D>::Unit(0), Kind::fluid, Vec<D>::Zero());
  s.velocity[1] = u;
  collide(s, {}, near_surface);
  if (s.id[0] == 1) s.reorder({1, 0});
  return s;
}

template <class T>
struct Collision : ::testing::Test {};
TYPED_TEST_SUITE(Collision, test::Dimensions);

TYPED_TEST(Collision, TakesTheApproachAndNothingElse) {
  constexpr int D = TypeParam::D;
  const Vec<D> x = Vec<D>::Unit(0), across = Vec<D>::Unit(1);
  const State<D> s = pair<D>(0.7 * l0, -2 * x + across);
  EXPECT_LT((s.velocity[0] + x).norm(), 1e-15);
  EXPECT_LT((s.velocity[1] - (-x + across)).norm(), 1e-15);
}

/// Velocity after its collisions of liquid with velocity u at height y over a wall of particles l0/2 below y = 0, the
/// particle that is nearest `beside` along the wall.
template <int D>
Vec<D> over_a_wall(double y, double beside, const Vec<D>& u, std::uint8_t near_surface = 0) {
  State<D> s;
  const int n = 3;
  for (int i = -n; i <= n; ++i)
    for (int k = D == 3 ? -n : 0; k <= (D == 3 ? n : 0); ++k) {
      Vec<D> r = Vec<D>::Zero();
      r[0] = i * l0, r[1] = -0.5 * l0;
      if constexpr (D == 3) r[2] = k * l0;
      s.add(r, Kind::wall, -Vec<D>::Unit(1));
    }
  Vec<D> r = Vec<D>::Constant(beside);
  r[1] = y;
  s.add(r, Kind::fluid, Vec<D>::Zero());
  s.velocity.back() = u;
  collide(s, {}, near_surface);
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.kind[i] == Kind::fluid) return s.velocity[i];
  return {};
}

TYPED_TEST(Collision, WithAWallLeavesTheVelocityAlongIt) {
  constexpr int D = TypeParam::D;
  const Vec<D> along = Vec<D>::Unit(0), down = -Vec<D>::Unit(1);
  for (double beside : {0.0, 0.2 * l0, 0.5 * l0})
    for (double y : {-0.2 * l0, 0.1 * l0, 0.29 * l0}) {
      EXPECT_LT((over_a_wall<D>(y, beside, 3 * along + down) - 3 * along).norm(), 1e-15) << y << ", " << beside;
      EXPECT_EQ(over_a_wall<D>(y, beside, 3 * along), Vec<D>(3 * along)) << y << ", " << beside;
      EXPECT_EQ(over_a_wall<D>(y, beside, along - down), Vec<D>(along - down)) << y << ", " << beside;
    }
}

TYPED_TEST(Collision, WithAWallReachesEquallyFarAllAlongItAndFurtherNearTheSurface) {
  constexpr int D = TypeParam::D;
  const Vec<D> along = Vec<D>::Unit(0), down = -Vec<D>::Unit(1), u = along + down;
  for (double beside : {0.0, 0.2 * l0, 0.5 * l0})
    for (const auto& [near, reach] : {std::pair<std::uint8_t, double>{0, 0.3}, {1, 0.5}}) {
      EXPECT_LT((over_a_wall<D>((reach - 0.01) * l0, beside, u, near) - along).norm(), 1e-15) << beside;
      EXPECT_EQ(over_a_wall<D>((reach + 0.01) * l0, beside, u, near), u) << beside;
    }
}

TYPED_TEST(Collision, LeavesPairsThatPartOrAreFarAlone) {
  constexpr int D = TypeParam::D;
  const Vec<D> x = Vec<D>::Unit(0);
  EXPECT_EQ(pair<D>(0.7 * l0, 2 * x).velocity[1], Vec<D>(2 * x));
  EXPECT_EQ(pair<D>(0.81 * l0, -2 * x).velocity[1], Vec<D>(-2 * x));
}

TYPED_TEST(Collision, ReachesFurtherNearTheSurface) {
  constexpr int D = TypeParam::D;
  const Vec<D> x = Vec<D>::Unit(0);
  EXPECT_EQ(pair<D>(0.99 * l0, -2 * x, Kind::fluid, 0).velocity[1], Vec<D>(-2 * x));
  EXPECT_LT((pair<D>(0.99 * l0, -2 * x, Kind::fluid, 1).velocity[1] + x).norm(), 1e-15);
  EXPECT_EQ(pair<D>(1.01 * l0, -2 * x, Kind::fluid, 1).velocity[1], Vec<D>(-2 * x));
}

template <int D>
std::pair<Vec<D>, double> momentum_and_energy(const State<D>& s) {
  Vec<D> momentum = Vec<D>::Zero();
  double energy = 0;
  for (const auto& u : s.velocity) momentum += u, energy += 0.5 * u.squaredNorm();
  return {momentum, energy};
}

TYPED_TEST(Collision, OfACloudKeepsMomentumAndLosesEnergy) {
  constexpr int D = TypeParam::D;
  for (int seed = 1; seed <= 20; ++seed) {
    State<D> s = test::random_cloud<D>(150, -l0, l0, seed);
    std::mt19937_64 random(100 + seed);  // not the positions' own
    for (auto& u : s.velocity) u = test::random_vec<D>(random, -1, 1);
    const auto [momentum, energy] = momentum_and_energy(s);
    collide(s);
    const auto [momentum_after, energy_after] = momentum_and_energy(s);
    EXPECT_LT((momentum_after - momentum).norm(), 1e-13 * static_cast<double>(s.size()));
    EXPECT_LT(energy_after, energy);
  }
}

TYPED_TEST(Collision, OfACloudBetweenWallsLosesEnergyEvenWhereAllFallTogether) {
  constexpr int D = TypeParam::D;
  for (int seed = 1; seed <= 20; ++seed) {
    State<D> s = test::random_cloud<D>(150, -l0, l0, seed);
    // The worst case for corrections that all act at once: everything runs towards one point.
    for (std::size_t i = 0; i < s.size(); ++i) {
      if (i % 3 == 0) s.kind[i] = Kind::wall;
      if (i % 3 != 0) s.velocity[i] = -s.position[i] / l0;
    }
    const double energy = momentum_and_energy(s).second;
    collide(s);
    EXPECT_LT(momentum_and_energy(s).second, energy);
    for (std::size_t i = 0; i < s.size(); ++i)
      if (s.kind[i] == Kind::wall) {
        EXPECT_TRUE(s.velocity[i].isZero());
      }
  }
}

}  // namespace
}  // namespace seiche::solver
