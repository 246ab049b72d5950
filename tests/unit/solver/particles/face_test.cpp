#include "solver/particles/face.hpp"

#include <gtest/gtest.h>

#include "solver/particles/state.hpp"

namespace seiche::solver {
namespace {

// A wall that fills x > 0, y > 0.
const std::vector<Face<2>> corner{{{1, 0}, 0}, {{0, 1}, 0}};

TEST(EnteredFace, IsTheOneThatThePairCrossesLast) {
  const Vec<2> inside(0.5, 0.5);
  EXPECT_EQ(entered_face<2>(corner, {-1, 0.6}, inside), Vec<2>(1, 0));
  EXPECT_EQ(entered_face<2>(corner, {0.6, -1}, inside), Vec<2>(0, 1));
  EXPECT_EQ(entered_face<2>(corner, {-1, -0.2}, inside), Vec<2>(1, 0)) << "y = 0 is crossed sooner";
  EXPECT_EQ(entered_face<2>(corner, {-0.2, -1}, inside), Vec<2>(0, 1));
}

TEST(EnteredFace, IsNoneForWhatLiesBehindAll) { EXPECT_TRUE(entered_face<2>(corner, {0.1, 0.2}, {0.5, 0.5}).isZero()); }

TEST(EnteredFace, LeavesOutFacesThatThePointIsNotBehind) {
  EXPECT_EQ(entered_face<2>(corner, {-1, -0.5}, {0.5, -0.1}), Vec<2>(1, 0));
}

TEST(State, KnowsTheNormalThatAPairMeets) {
  State<2> s;
  s.edges = {corner};
  s.add({0.5, 0.5}, Kind::wall, {0, 1});
  EXPECT_EQ(s.normal_from({-1, 0.6}, 0), Vec<2>(0, 1)) << "beside no edge it is the particle's own";
  s.edge[0] = 0;
  EXPECT_EQ(s.normal_from({-1, 0.6}, 0), Vec<2>(1, 0));
  s.add({0.6, 0.5}, Kind::wall, {0, 1}, 0.5);
  s.reorder({1, 0});
  EXPECT_EQ(s.edge, (std::vector<int>{-1, 0}));
  EXPECT_EQ(s.volume, (Scalars{0.5, 1}));
}

}  // namespace
}  // namespace seiche::solver
