#include "solver/operators/viscosity.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver {
namespace {

using test::l0;

template <class T>
struct ViscosityOf : ::testing::Test {};
TYPED_TEST_SUITE(ViscosityOf, test::Dimensions);

/// Force of the model on the middle of a block that moves at u(r), nu = 0.25 m^2/s.
template <int D, class F>
Vec<D> force(ViscousModel model, F u) {
  Parameters p;
  p.particles.spacing = l0;
  p.method.viscous = model;
  p.fluid.viscosity = 0.25;
  State<D> s = test::block<D>(7);
  Range<D> range(p, p.method.radius_laplacian);
  range.measure(test::listed(s, 2.6 * l0), s);
  for (std::size_t i = 0; i < s.size(); ++i) s.velocity[i] = u(s.position[i]);
  Vecs<D> out;
  Viscosity<D> viscosity(p);
  viscosity(range, s, out);
  return out[test::nearest<D>(s, Vec<D>::Zero())];
}

TYPED_TEST(ViscosityOf, IsNuTimesTheLaplacianOfAQuadraticFlow) {
  constexpr int D = TypeParam::D;
  const Vec<D> direction = test::slanted<D>();
  const auto u = [&](const Vec<D>& r) { return Vec<D>(r.squaredNorm() * direction); };
  const Vec<D> exact = 0.25 * 2 * D * direction;
  EXPECT_LT((force<D>(ViscousModel::laplacian, u) - exact).norm(), 1e-9 * exact.norm());
}

TYPED_TEST(ViscosityOf, OfARotationIsNoneInTheFormOfTheStrainRate) {
  constexpr int D = TypeParam::D;
  // About an axis far away, r^2 turned by a right angle would shear; a rigid rotation doesn't.
  const auto u = [](const Vec<D>& r) {
    Vec<D> turned = Vec<D>::Zero();
    turned[0] = -(r[1] - 1);
    turned[1] = r[0] - 1;
    return turned;
  };
  EXPECT_LT(force<D>(ViscousModel::strain_rate, u).norm(), 1e-9);
}

TYPED_TEST(ViscosityOf, TellsTheTwoFormsApart) {
  constexpr int D = TypeParam::D;
  const auto u = [](const Vec<D>& r) { return Vec<D>(r[0] * r[0] * Vec<D>::Unit(0)); };
  const double laplacian = force<D>(ViscousModel::laplacian, u)[0];
  EXPECT_NEAR(laplacian, 0.25 * 2, 1e-9);
  EXPECT_GT(force<D>(ViscousModel::strain_rate, u)[0], 2 * laplacian) << "compression counts thrice";
}

}  // namespace
}  // namespace seiche::solver
