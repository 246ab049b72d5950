#include "solver/pressure/pressure_system.hpp"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

using test::l0;
using test::StillTank;

/// The small tank with its water stirred, so that nothing is symmetric by luck.
template <int D>
StillTank<D> stirred_tank() {
  StillTank<D> tank;
  std::mt19937_64 random(11);
  for (std::size_t i = 0; i < tank.s.size(); ++i)
    if (tank.s.kind[i] == Kind::fluid) tank.s.position[i] += 0.14 * l0 * test::random_vec<D>(random, -1, 1) / D;
  tank.find_surface();
  return tank;
}

template <class T>
struct PressureSystemOf : ::testing::Test {};
TYPED_TEST_SUITE(PressureSystemOf, test::Dimensions);

/// Calls check(tank, system, boundary) for both boundaries.
template <int D, class F>
void each_boundary(double diagonal, F check) {
  const StillTank<D> tank = stirred_tank<D>();
  const auto with = [&](const char* name, const auto& boundary) {
    SCOPED_TRACE(name);
    auto system = tank.system(boundary, diagonal);
    ASSERT_GT(system.rows(), 150);
    check(tank, system, boundary);
  };
  with("PaperBoundary", tank.paper());
  with("GhostBoundary", tank.ghost());
}

TYPED_TEST(PressureSystemOf, IsSymmetricWithSortedColumns) {
  each_boundary<TypeParam::D>(0, [](const auto&, const auto& system, const auto&) {
    const SparseMatrix a = system.matrix(), transposed = a.transpose();
    EXPECT_EQ((a - transposed).norm(), 0) << "to the last bit";
    for (int k = 0; k < a.rows(); ++k) {
      int last = -1, diagonals = 0;
      for (SparseMatrix::InnerIterator it(a, k); it; ++it) {
        EXPECT_GT(it.col(), last);
        last = it.col();
        diagonals += it.col() == k;
        if (it.col() != k) {
          EXPECT_LT(it.value(), 0);
        }
      }
      EXPECT_EQ(diagonals, 1);
    }
  });
}

TYPED_TEST(PressureSystemOf, IsPositiveDefinite) {
  each_boundary<TypeParam::D>(0, [](const auto&, const auto& system, const auto&) {
    const SparseMatrix rows = system.matrix();
    const Eigen::SparseMatrix<double> a = rows;
    const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> cholesky(a);
    EXPECT_EQ(cholesky.info(), Eigen::Success);
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 10; ++k) {
      const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(a.rows(), [&] { return normal(random); });
      EXPECT_GT(x.dot(a * x), 0);
    }
    EXPECT_GT(Eigen::VectorXd::Ones(a.rows()).dot(a * Eigen::VectorXd::Ones(a.rows())), 0);
  });
}

TYPED_TEST(PressureSystemOf, RowsSumToWhatIsKnownAroundThem) {
  constexpr int D = TypeParam::D;
  constexpr double diagonal = 0.125;
  each_boundary<D>(diagonal, [](const StillTank<D>& tank, const auto& system, const auto& boundary) {
    const SparseMatrix a = system.matrix();
    const Eigen::VectorXd sums = a * Eigen::VectorXd::Ones(a.rows());
    int beside_the_surface = 0;
    for (int k = 0; k < a.rows(); ++k) {
      const int i = system.particle(k);
      double known = 0;  // weights of the neighbours whose pressure is given
      for (int j : tank.list[i])
        if (tank.s.surface[j] && boundary.pair_diagonal(j, 1) > 0)
          known += tank.w((tank.s.position[j] - tank.s.position[i]).norm());
      beside_the_surface += known > 0;
      EXPECT_NEAR(sums[k], diagonal + boundary.diagonal(i) + known, 1e-13 * a.coeff(k, k));
    }
    EXPECT_GT(beside_the_surface, 10);
    EXPECT_LT(beside_the_surface, a.rows() / 2);
  });
}

TYPED_TEST(PressureSystemOf, ReadsAsTheLaplacianInsideTheWater) {
  constexpr int D = TypeParam::D;
  StillTank<D> tank;
  const auto system = tank.system(tank.ghost());
  Eigen::VectorXd p(system.rows());
  for (int k = 0; k < system.rows(); ++k) p[k] = tank.s.position[system.particle(k)].squaredNorm();
  const Vec<D> middle = 0.5 * Vec<D>(Vec<D>::Constant(0.1)).cwiseMin(test::small_tank<D>().tank.length);
  const int i = test::nearest<D>(tank.s, middle), k = system.row(i);
  const double scale = tank.ref.lambda * tank.ref.n0 / (2 * D);  // -scale * Laplacian, and that of r^2 is 2 d
  EXPECT_NEAR((system.matrix() * p)[k], -scale * 2 * D, 1e-12 * scale);
}

TYPED_TEST(PressureSystemOf, RowsAndParticlesNameEachOther) {
  each_boundary<TypeParam::D>(0, [](const auto& tank, const auto& system, const auto& boundary) {
    int rows = 0;
    for (int i = 0; i < static_cast<int>(tank.s.size()); ++i) {
      EXPECT_EQ(system.row(i) >= 0, boundary.unknown(i));
      if (system.row(i) < 0) continue;
      EXPECT_EQ(system.row(i), rows++);
      EXPECT_EQ(system.particle(system.row(i)), i);
    }
    EXPECT_EQ(rows, system.rows());
  });
}

TEST(PressureSystem, OfNoUnknownHasNoRows) {
  State<2> s = test::block<2>(2);
  for (auto& flag : s.surface) flag = 1;
  const auto list = test::listed(s, 2 * l0);
  PressureSystem<2> system;
  system.assemble(test::measured(KF3{2 * l0}, list, s), 0, PaperBoundary<2>{s}, s);
  EXPECT_EQ(system.rows(), 0);
  EXPECT_EQ(system.matrix().nonZeros(), 0);
}

}  // namespace
}  // namespace seiche::solver
