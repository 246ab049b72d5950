#pragma once
#include <gtest/gtest.h>

#include <random>

#include "solver/tank/shape.hpp"

namespace seiche::solver::test {

struct Enclosed {
  Vec<3> normal = Vec<3>::Zero();  ///< integral of the outward normal over the surface
  double area = 0, volume = 0;
};

/// By the divergence theorem.
inline Enclosed enclosed(const SurfaceMesh& mesh) {
  Enclosed sum;
  for (const auto& patch : mesh.patches)
    for (const auto& face : patch.faces) {
      const auto at = [&](std::size_t k) { return Vec<3>(mesh.points[static_cast<std::size_t>(face[k])].data()); };
      for (std::size_t k = 1; k + 1 < face.size(); ++k) {
        const Vec<3> a = at(0), b = at(k) - a, c = at(k + 1) - a;
        const Vec<3> normal =
            0.5 * Vec<3>(b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]);
        sum.normal += normal;
        sum.area += normal.norm();
        sum.volume += a.dot(normal) / 3;
      }
    }
  return sum;
}

/// At random points round the tank: the foot is on the wall and as far as said, the normal leads to it, and no corner
/// of the surface mesh is nearer.
inline void expect_exact_distances(const Shape<3>& tank, int samples, double coarseness) {
  const SurfaceMesh mesh = tank.surface();
  const Bounds<3> bounds = tank.bounds();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(-0.3, 1.3);
  for (int sample = 0; sample < samples; ++sample) {
    Vec<3> r;
    for (int a = 0; a < 3; ++a) r[a] = bounds.low[a] + share(random) * bounds.size()[a];
    const Nearest<3> wall = tank.nearest(r);
    EXPECT_NEAR((r - wall.foot).norm(), std::abs(wall.distance), 1e-12);
    EXPECT_NEAR(tank.nearest(wall.foot).distance, 0, 1e-12);
    EXPECT_NEAR(wall.normal.norm(), 1, 1e-12);
    EXPECT_GT((r - wall.foot).dot(wall.normal) * wall.distance, -1e-12);
    double least = 1e9;
    for (const auto& point : mesh.points) least = std::min(least, (Vec<3>(point.data()) - r).norm());
    EXPECT_LE(std::abs(wall.distance), least + 1e-12);
    EXPECT_GE(std::hypot(wall.distance, coarseness), least) << r.transpose();
    // The way to the foot stays on one side of the wall, and goes on on the other unless the foot is on an edge.
    const Vec<3> step = 1e-6 * bounds.size().norm() * (r - wall.foot).normalized();
    EXPECT_GT(tank.nearest(wall.foot + step).distance * wall.distance, 0);
    if ((r - wall.foot - wall.distance * wall.normal).norm() < 1e-9) {
      EXPECT_LT(tank.nearest(wall.foot - step).distance * wall.distance, 0);
    }
  }
}

}  // namespace seiche::solver::test
