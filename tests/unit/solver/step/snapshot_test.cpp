#include "solver/step/snapshot.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

template <class T>
struct Snapshot : ::testing::Test {};
TYPED_TEST_SUITE(Snapshot, test::Dimensions);

TYPED_TEST(Snapshot, HasEveryArrayInTheOrderOfTheIds) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(5, 1, 2);
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.velocity[i] = 10 * s.position[i];
    s.pressure[i] = 100 * s.position[i][0];
    s.kind[i] = i == 2 ? Kind::wall : Kind::fluid;
    s.surface[i] = i == 3;
  }
  s.reorder({4, 2, 0, 3});  // sorted otherwise, and one taken out
  for (std::size_t i = 0; i < s.size(); ++i) s.density[i] = 2 * s.position[i][1];
  s.time = 0.125;
  s.step = 9;
  const Motion motion(
      {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.1, 1}, .start = Start::smooth});
  const auto frame = snapshot(s, 2, motion);

  EXPECT_EQ(frame->id, (std::vector<std::uint32_t>{0, 2, 3, 4}));
  EXPECT_EQ(frame->kind, (std::vector{Kind::fluid, Kind::wall, Kind::fluid, Kind::fluid}));
  EXPECT_EQ(frame->free_surface, (std::vector<std::uint8_t>{0, 0, 1, 0}));
  EXPECT_EQ(frame->time, 0.125);
  EXPECT_EQ(frame->step, 9);
  EXPECT_EQ(frame->pose.displacement[0], motion.at(DegreeOfFreedom::surge, 0.125).value);
  const State<D> made = test::random_cloud<D>(5, 1, 2);
  for (std::size_t k = 0; k < frame->size(); ++k) {
    const Vec<D>& r = made.position[frame->id[k]];
    EXPECT_FLOAT_EQ(frame->pressure[k], 100 * r[0]);
    EXPECT_FLOAT_EQ(frame->number_density[k], r[1]);
    for (int a = 0; a < 3; ++a) {
      EXPECT_FLOAT_EQ(frame->position[k][a], a < D ? r[a] : 0);
      EXPECT_FLOAT_EQ(frame->velocity[k][a], a < D ? 10 * r[a] : 0);
    }
  }
}

}  // namespace
}  // namespace seiche::solver
