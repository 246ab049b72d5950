#include "solver/tank/box.hpp"

#include <gtest/gtest.h>

#include "solver/errors.hpp"
#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

template <class T, int D = T::D>
struct BoxOf : ::testing::Test {
  static Parameters parameters(bool closed) {
    Parameters p;
    p.tank = {.length = 0.6, .height = 0.4, .width = D == 3 ? 0.3 : 0, .closed = closed};
    return p;
  }
  Box<D> closed{parameters(true)}, open{parameters(false)};
  Vec<D> high = closed.bounds().high, middle = 0.5 * high;
};
TYPED_TEST_SUITE(BoxOf, test::Dimensions);

TYPED_TEST(BoxOf, KnowsTheNearestPointOfEachWall) {
  constexpr int D = TypeParam::D;
  const SurfaceMesh mesh = this->closed.surface();
  for (int axis = 0; axis < D; ++axis)
    for (const bool top : {false, true})
      for (const double beyond : {-0.05, 0.03}) {
        Vec<D> r = this->middle;
        r[axis] = top ? this->high[axis] + beyond : -beyond;
        const Nearest<D> wall = this->closed.nearest(r);
        EXPECT_NEAR(wall.distance, beyond, 1e-15);
        EXPECT_EQ(wall.normal, Vec<D>((top ? 1 : -1) * Vec<D>::Unit(axis)));
        EXPECT_LT((wall.foot + beyond * wall.normal - r).norm(), 1e-15);
        const char* names[][2] = {{"left", "right"}, {"floor", "roof"}, {"near", "far"}};
        EXPECT_EQ(mesh.patches[static_cast<std::size_t>(wall.patch)].name, names[axis][top]);
      }
}

TYPED_TEST(BoxOf, IsAsFarFromACornerAsTheCornerIs) {
  constexpr int D = TypeParam::D;
  const Vec<D> off = Vec<D>::LinSpaced(0.01, 0.03);
  const Nearest<D> wall = this->closed.nearest(this->high + off);
  EXPECT_DOUBLE_EQ(wall.distance, off.norm());
  EXPECT_EQ(wall.foot, this->high);
}

TYPED_TEST(BoxOf, HasTheNormalOfTheSideWallInACorner) {
  constexpr int D = TypeParam::D;
  const auto axis_at = [&](const Vec<D>& r) {
    int axis;
    this->closed.nearest(r).normal.cwiseAbs().maxCoeff(&axis);
    return axis;
  };
  Vec<D> r = Vec<D>::Zero();
  EXPECT_EQ(axis_at(r), 0);
  r[0] = this->middle[0];
  EXPECT_EQ(axis_at(r), D == 3 ? 2 : 1) << "the near wall before the floor";
}

TYPED_TEST(BoxOf, HasNoRoofWhereItIsOpen) {
  constexpr int D = TypeParam::D;
  Vec<D> r = this->middle;
  r[1] = 10 * this->high[1];
  EXPECT_DOUBLE_EQ(this->open.nearest(r).distance, -0.5 * this->high[D - 1 == 2 ? 2 : 0]);
  EXPECT_FALSE(this->open.is_closed());
  EXPECT_EQ(this->open.surface().patches.size(), this->closed.surface().patches.size() - 1);
}

/// Integral of the outward normal, and volume by the divergence theorem.
template <int D>
std::pair<Vec<3>, double> of_surface(const SurfaceMesh& mesh) {
  Vec<3> sum = Vec<3>::Zero();
  double volume = 0;
  for (const auto& patch : mesh.patches)
    for (const auto& face : patch.faces) {
      const auto at = [&](std::size_t k) { return Vec<3>(mesh.points[static_cast<std::size_t>(face[k])].data()); };
      for (std::size_t k = 1; k + 1 < (D == 2 ? 3 : face.size()); ++k) {
        const Vec<3> normal =
            D == 2 ? (at(1) - at(0)).cross(Vec<3>::UnitZ()) : 0.5 * (at(k) - at(0)).cross(at(k + 1) - at(0));
        sum += normal;
        volume += at(0).dot(normal) / D;
      }
    }
  return {sum, volume};
}

TYPED_TEST(BoxOf, SurfaceIsClosedAndFacesOutwards) {
  constexpr int D = TypeParam::D;
  const SurfaceMesh mesh = this->closed.surface();
  const auto [normal, volume] = of_surface<D>(mesh);
  EXPECT_LT(normal.norm(), 1e-15);
  EXPECT_NEAR(volume, this->high.prod(), 1e-15);
  for (int axis = 0; axis < D; ++axis) EXPECT_EQ(mesh.size()[static_cast<std::size_t>(axis)], this->high[axis]);
}

TYPED_TEST(BoxOf, IsLinedByTheLatticeThatFillsItsTank) {
  constexpr int D = TypeParam::D;
  for (const bool with_roof : {true, false}) {
    Parameters p = test::small_tank<D>();
    p.tank.closed = with_roof;
    const State<D> tank = fill_tank<D>(p);
    const int layers = wall_layers(p.method);
    const auto points = Box<D>(p).wall_points(layers, test::l0, 3 * test::l0);
    std::size_t next = 0;
    while (tank.kind[next] == Kind::fluid) ++next;
    for (const bool first : {true, false})
      for (const auto& point : points)
        if ((point.layer == 0) == first) {
          ASSERT_LT(next, tank.size());
          EXPECT_EQ(tank.kind[next], first ? Kind::wall : Kind::dummy);
          EXPECT_EQ(tank.position[next], point.position);
          EXPECT_EQ(tank.normal[next], point.normal);
          EXPECT_EQ(point.weight, 1);
          ++next;
        }
    EXPECT_EQ(next, tank.size());
  }
}

TEST(CheckBox, WantsWholeSpacingsBelowARim) {
  Parameters p;
  p.tank.closed = false;
  p.tank.length = 0.6012;
  EXPECT_THROW(check_shape(p), BadParameters);
  p.tank.length = 0.6;
  EXPECT_NO_THROW(check_shape(p));
  p.tank.width = 3 * p.particles.spacing;
  EXPECT_THROW(check_shape(p), BadParameters);
}

}  // namespace
}  // namespace seiche::solver
