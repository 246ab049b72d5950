#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solver/pressure/amg/amg.hpp"
#include "tests/unit/solver/stirred_system.hpp"

// The parts of the multigrid preconditioner: strong links, sweeps, aggregates, the next level's matrix, the last level.
namespace seiche::solver {
namespace {

using test::StirredSystem;

SparseMatrix written_out(const AmgMatrix& a) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < a.rows; ++i) {
    entries.emplace_back(i, i, a.diagonal[i]);
    for (int k = a.row[i].lower; k < a.row[i].end; ++k) entries.emplace_back(i, a.column[k], -a.weight[k]);
  }
  SparseMatrix written(a.rows, a.rows);
  written.setFromTriplets(entries.begin(), entries.end());
  return written;
}

/// Six chunks.
struct AmgLevels : ::testing::Test {
  StirredSystem<2> s{{95, 32}};
  AmgMatrix a;
  Aggregates p;
  AmgLevels() {
    a.keep_strong(s.matrix());
    p.find(a);
  }
  Eigen::VectorXd some(double step) const {
    return (Eigen::ArrayXd::LinSpaced(a.rows, 0, step * a.rows).sin() + 0.1).matrix();
  }
};

TEST_F(AmgLevels, StrongLinksAreThoseOfATenthOfTheStrongestOfEitherRow) {
  const SparseMatrix full = s.matrix();
  const SparseMatrix kept = written_out(a);
  EXPECT_EQ((kept - SparseMatrix(kept.transpose())).norm(), 0);
  EXPECT_LT(kept.nonZeros(), 0.55 * full.nonZeros());
  std::vector<double> strongest(a.rows, 0);
  for (int i = 0; i < a.rows; ++i)
    for (SparseMatrix::InnerIterator it(full, i); it; ++it) strongest[i] = std::max(strongest[i], -it.value());
  for (int i = 0; i < a.rows; ++i)
    for (SparseMatrix::InnerIterator it(full, i); it; ++it) {
      const int j = it.col();
      if (j == i) continue;
      const bool strong = -it.value() >= 0.1 * std::min(strongest[i], strongest[j]);
      EXPECT_EQ(kept.coeff(i, j), strong ? static_cast<float>(it.value()) : 0);
    }
  const Eigen::VectorXd ones = Eigen::VectorXd::Ones(a.rows);
  EXPECT_LT((kept * ones - full * ones).lpNorm<Eigen::Infinity>(), 1e-13) << "sums of rows are kept";
}

TEST_F(AmgLevels, LinksAreSortedByWhereTheyLead) {
  for (int i = 0; i < a.rows; ++i) {
    const int first = i / chunk_rows * chunk_rows, last = first + chunk_rows;
    const auto [lower, outside, upper, end] = a.row[i];
    for (int k = lower; k < end; ++k) {
      const int j = a.column[k];
      EXPECT_EQ(k < outside, j >= first && j < i);
      EXPECT_EQ(k >= outside && k < upper, j < first || j >= last);
      EXPECT_EQ(k >= upper, j > i && j < last);
    }
  }
}

TEST_F(AmgLevels, TheResidualAfterASweepIsTheResidual) {
  const Eigen::VectorXd b = some(0.7);
  Eigen::VectorXd x(a.rows), r(a.rows), product(a.rows);
  a.sweep_up(b.data(), x.data());
  for (int i = 0; i < a.rows; ++i) {
    r[i] = a.residual_after_sweep_up(i, x.data());
    product[i] = a.product(i, x.data());
  }
  EXPECT_LT((b - written_out(a) * x - r).norm(), 1e-13 * b.norm());
  EXPECT_LT((written_out(a) * x - product).norm(), 1e-13 * b.norm());
}

TEST_F(AmgLevels, TheSweepDownIsTheAdjointOfTheSweepUpAndKeepsTheAnswer) {
  const Eigen::VectorXd u = some(0.7), v = some(1.3), zero = Eigen::VectorXd::Zero(a.rows);
  Eigen::VectorXd up(a.rows), down(a.rows);
  a.sweep_up(u.data(), up.data());
  a.sweep_down(v.data(), zero.data(), down.data());
  EXPECT_NEAR(v.dot(up), u.dot(down), 1e-12 * u.norm() * v.norm());

  const Eigen::VectorXd b = written_out(a) * u;
  a.sweep_down(b.data(), u.data(), down.data());
  EXPECT_LT((down - u).norm(), 1e-13 * u.norm());
}

TEST_F(AmgLevels, AggregatesPartTheRows) {
  EXPECT_GT(p.count, a.rows / 7);
  EXPECT_LT(p.count, a.rows / 3);
  ASSERT_EQ(p.start.size(), p.count + 1u);
  EXPECT_EQ(p.start.front(), 0);
  EXPECT_EQ(p.start.back(), a.rows);
  std::vector<int> met(a.rows, 0);
  for (int g = 0; g < p.count; ++g) {
    EXPECT_GE(p.start[g + 1] - p.start[g], 2);
    EXPECT_LE(p.start[g + 1] - p.start[g], 20);
    p.each_member(g, [&](int i) {
      EXPECT_EQ(p.of[i], g);
      ++met[i];
    });
  }
  EXPECT_EQ(met, std::vector<int>(a.rows, 1));
}

TEST_F(AmgLevels, TheNextMatrixIsTheGalerkinProduct) {
  Galerkin galerkin;
  AmgMatrix coarse, again;
  galerkin.form(a, p, coarse);
  galerkin.form(a, p, again);
  SparseMatrix prolong(a.rows, p.count);
  for (int i = 0; i < a.rows; ++i) prolong.insert(i, p.of[i]) = 1;
  const SparseMatrix expected = SparseMatrix(prolong.transpose()) * written_out(a) * prolong;
  EXPECT_LT((written_out(coarse) - expected).norm(), 1e-6 * expected.norm());
  EXPECT_EQ((written_out(coarse) - written_out(again)).norm(), 0);

  const Eigen::VectorXd sums = Eigen::Map<const Eigen::VectorXd>(a.sum.data(), a.rows);
  const Eigen::VectorXd coarse_sums = Eigen::Map<const Eigen::VectorXd>(coarse.sum.data(), coarse.rows);
  EXPECT_LT((prolong.transpose() * sums - coarse_sums).norm(), 1e-13 * sums.norm()) << "more exactly than a float";
}

TEST_F(AmgLevels, ComeDownToAFewRowsByTwoAtLeast) {
  Amg amg;
  amg.set_up(s.matrix());
  ASSERT_GE(amg.levels(), 3);
  for (int l = 1; l < amg.levels(); ++l) EXPECT_LE(2 * amg.level(l).matrix.rows, amg.level(l - 1).matrix.rows);
  EXPECT_LE(amg.level(amg.levels() - 1).matrix.rows, 200);
}

TEST(Aggregates, LeaveOutRowsWithoutLinks) {
  SparseMatrix three(3, 3);
  three.insert(0, 0) = three.insert(1, 1) = three.insert(2, 2) = 2;
  three.insert(0, 2) = three.insert(2, 0) = -1;
  three.makeCompressed();
  AmgMatrix a;
  a.keep_strong({3, 3, 5, three.outerIndexPtr(), three.innerIndexPtr(), three.valuePtr()});
  Aggregates p;
  p.find(a);
  EXPECT_EQ(p.of, (std::vector<int>{0, -1, 0}));
  EXPECT_EQ(p.member, (std::vector<int>{0, 2}));
}

TEST(Skyline, SolvesExactlyAlsoWhatIsSingular) {
  for (double diagonal : {1., 1e-7, 0.}) {
    SCOPED_TRACE(diagonal);
    const StirredSystem<2> s({14, 10}, 0.15, true, diagonal);
    AmgMatrix a;
    a.keep_strong(s.matrix());
    Eigen::VectorXd b = s.b, x(a.rows);
    b.array() -= b.mean();  // so that there is an answer in any case
    Skyline skyline;
    skyline.factorise(a);
    skyline.solve(b.data(), x.data());
    EXPECT_LT((written_out(a) * x - b).norm(), 1e-9 * b.norm());
  }
}

TEST(ChunkSums, AddUpEveryRowOnce) {
  ChunkSums sums;
  for (int rows : {0, 1, chunk_rows, chunk_rows + 1, 10 * chunk_rows - 1}) {
    const auto [count, total] = sums.add_up<2>(rows, [](int i, auto& s) {
      s[0] += 1;
      s[1] += i;
    });
    EXPECT_EQ(count, rows);
    EXPECT_EQ(total, 0.5 * rows * (rows - 1.));
  }
}

}  // namespace
}  // namespace seiche::solver
