#include "solver/particles/pairs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "solver/operators/kernels.hpp"
#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct PairsOf : ::testing::Test {};
TYPED_TEST_SUITE(PairsOf, test::Dimensions);

TYPED_TEST(PairsOf, AListAreThoseWithinTheSupportInItsOrder) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(200, -3 * l0, 3 * l0);
  for (std::size_t i = 0; i < s.size(); i += 5) s.kind[i] = Kind::dummy;
  const KF4 w{1.5 * l0};
  const auto list = test::listed(s, w.support, 0.5 * l0);
  for (auto& r : s.position) r *= 1.05;  // particles have moved since the list was made
  const auto pairs = test::measured(w, list, s);
  std::size_t left_out = 0;
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    std::vector<int> expected;
    if (s.kind[i] != Kind::dummy)
      for (int j = 0; j < static_cast<int>(s.size()); ++j)
        if (j != i && (s.position[j] - s.position[i]).norm() < w.support) expected.push_back(j);
    EXPECT_EQ(std::vector<int>(pairs[i].begin(), pairs[i].end()), expected);
    left_out += list[i].size() - expected.size();
  }
  EXPECT_GT(left_out, 0u) << "else the skin isn't tested";
}

TYPED_TEST(PairsOf, AListHaveALeastDistance) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(700, -3 * l0, 3 * l0);  // of more than one chunk
  for (std::size_t i = 0; i < s.size(); i += 5) s.kind[i] = Kind::dummy;
  const KF4 w{1.5 * l0};
  const auto least = [&](const auto& pairs) {
    double value = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < s.size(); ++i)
      for (std::size_t j = 0; j < s.size(); ++j)
        if (j != i && s.kind[i] != Kind::dummy) value = std::min(value, (s.position[j] - s.position[i]).norm());
    EXPECT_DOUBLE_EQ(pairs.least_distance(), value);
  };
  const auto list = test::listed(s, w.support, 0.5 * l0);
  Pairs<D> pairs;
  pairs.measure(w, list, s);
  least(pairs);
  for (auto& r : s.position) r *= 1.05;  // measured anew, it may rise
  pairs.measure(w, list, s);
  least(pairs);
}

TYPED_TEST(PairsOf, AKernelHaveItsWeightOverTheSquaredDistance) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(60, -2 * l0, 2 * l0);
  for (const Kernel& kernel : kernel_table(2 * l0))
    std::visit(
        [&](const auto& w) {
          const auto pairs = test::measured(w, test::listed(s, w.support), s);
          for (int i = 0; i < 60; ++i)
            pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
              EXPECT_EQ(rij, Vec<D>(s.position[j] - s.position[i]));
              EXPECT_DOUBLE_EQ(weight * rij.squaredNorm(), w(rij.norm())) << w.name;
            });
        },
        kernel);
}

}  // namespace
}  // namespace seiche::solver
