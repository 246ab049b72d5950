#include "solver/particles/neighbours.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

template <int D>
std::vector<int> by_brute_force(const State<D>& s, int i, double reach) {
  std::vector<int> found;
  for (int j = 0; j < static_cast<int>(s.size()); ++j)
    if (j != i && (s.position[j] - s.position[i]).squaredNorm() < reach * reach) found.push_back(j);
  return found;
}

/// Every row against brute force, which is in rising order.
template <int D>
void expect_all_pairs(State<D> s, double radius, double skin, const Vec<D>& low, const Vec<D>& high) {
  Neighbours<D> list(low, high, radius, skin);
  list.build(s);
  std::size_t pairs = 0;
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    const std::vector<int> row(list[i].begin(), list[i].end());
    ASSERT_EQ(row, by_brute_force(s, i, radius + skin)) << "row " << i << " at " << s.position[i].transpose();
    pairs += row.size();
  }
  EXPECT_GT(pairs, s.size()) << "the cloud is too thin to test anything";
}

template <class T>
struct NeighboursOf : ::testing::Test {};
TYPED_TEST_SUITE(NeighboursOf, test::Dimensions);

TYPED_TEST(NeighboursOf, RandomCloudsMatchBruteForce) {
  constexpr int D = TypeParam::D;
  for (int seed : {1, 2, 3})
    for (double radius : {0.11, 0.2, 0.37, 1.5})
      expect_all_pairs<D>(test::random_cloud<D>(600, 0, 1, seed), radius, 0.1 * radius, Vec<D>::Zero(), Vec<D>::Ones());
}

TYPED_TEST(NeighboursOf, ParticlesOnCellEdgesMatchBruteForce) {
  constexpr int D = TypeParam::D;
  // Binary fractions, so that positions lie exactly on edges and distances are exactly the radius.
  for (double spacing : {0.0625, 0.125})
    expect_all_pairs<D>(test::block<D>(9, spacing), 0.125, 0.125, Vec<D>::Constant(-0.5), Vec<D>::Constant(0.5));
}

TYPED_TEST(NeighboursOf, ParticlesOutsideTheBoxMatchBruteForce) {
  constexpr int D = TypeParam::D;
  expect_all_pairs<D>(test::random_cloud<D>(600, -1, 2), 0.3, 0.05, Vec<D>::Zero(), Vec<D>::Ones());
}

TYPED_TEST(NeighboursOf, ABoxSmallerThanTheRadiusMatchesBruteForce) {
  constexpr int D = TypeParam::D;
  expect_all_pairs<D>(test::random_cloud<D>(100, 0, 1), 3, 0.3, Vec<D>::Zero(), Vec<D>::Ones());
}

TYPED_TEST(NeighboursOf, DummiesHaveEmptyRowsButAreListed) {
  constexpr int D = TypeParam::D;
  State<D> s = test::block<D>(5);
  for (std::size_t i = 0; i < s.size(); i += 3) s.kind[i] = Kind::dummy;
  const auto list = test::listed(s, 1.5 * test::l0);
  for (int i = 0; i < static_cast<int>(s.size()); ++i) {
    const std::vector<int> row(list[i].begin(), list[i].end());
    const bool dummy = s.kind[i] == Kind::dummy;
    EXPECT_EQ(row, dummy ? std::vector<int>{} : by_brute_force(s, i, 1.5 * test::l0));
  }
}

TYPED_TEST(NeighboursOf, BuildingKeepsEachParticleTogether) {
  constexpr int D = TypeParam::D;
  const State<D> before = test::random_cloud<D>(300, 0, 1);
  State<D> s = before;
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.velocity[i] = 2 * s.position[i];
    s.pressure[i] = s.position[i].sum();
  }
  test::listed(s, 0.2);
  std::vector<int> seen(s.size());
  for (std::size_t i = 0; i < s.size(); ++i) {
    ++seen[s.id[i]];
    EXPECT_EQ(s.position[i], before.position[s.id[i]]);
    EXPECT_EQ(s.velocity[i], 2 * s.position[i]);
    EXPECT_EQ(s.pressure[i], s.position[i].sum());
  }
  EXPECT_EQ(seen, std::vector<int>(s.size(), 1));
}

TYPED_TEST(NeighboursOf, TheOrderIsStable) {
  constexpr int D = TypeParam::D;
  State<D> s = test::random_cloud<D>(500, 0, 1);
  auto list = test::listed(s, 0.4);
  const auto once = s.id;
  list.build(s);
  EXPECT_EQ(s.id, once) << "building again moves nobody";
}

TYPED_TEST(NeighboursOf, TheListIsTheSameForAnyNumberOfThreads) {
  constexpr int D = TypeParam::D;
  const int threads = omp_get_max_threads();
  std::vector<std::vector<int>> rows[2];
  for (int k : {0, 1}) {
    omp_set_num_threads(k + 1);
    State<D> s = test::random_cloud<D>(500, 0, 1);
    const auto list = test::listed(s, 0.3);
    for (int i = 0; i < static_cast<int>(s.size()); ++i) rows[k].emplace_back(list[i].begin(), list[i].end());
  }
  omp_set_num_threads(threads);
  EXPECT_EQ(rows[0], rows[1]);
}

}  // namespace
}  // namespace seiche::solver
