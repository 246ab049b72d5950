#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>

#include "solver/tank/shape.hpp"

namespace seiche::solver::test {

/// Sum of the weights of each layer.
template <int D>
std::vector<double> layer_weights(const std::vector<WallPoint<D>>& points, int layers) {
  std::vector<double> sums(static_cast<std::size_t>(layers));
  for (const auto& point : points) sums.at(static_cast<std::size_t>(point.layer)) += point.weight;
  return sums;
}

/// Of each point the distance to the nearest other, those that `counts` alone.
template <int D, class Counts>
std::vector<double> gaps(const std::vector<WallPoint<D>>& points, Counts counts) {
  std::vector<double> all;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i && counts(points[i], points[j]))
        least = std::min(least, (points[i].position - points[j].position).norm());
    all.push_back(least);
  }
  return all;
}

template <int D>
double least_gap(const std::vector<WallPoint<D>>& points) {
  const auto all = gaps<D>(points, [](const auto&, const auto&) { return true; });
  return *std::min_element(all.begin(), all.end());
}

/// Every point of a layer is as far behind the wall as its layer; beyond a corner farther, up to a mitre's length.
template <int D>
void expect_at_their_layers(const Shape<D>& tank, const std::vector<WallPoint<D>>& points, double l0,
                            double tolerance = 1e-6) {
  for (const auto& point : points) {
    const double depth = (point.layer + 0.5) * l0, distance = tank.nearest(point.position).distance;
    if (point.normal.isZero()) {
      EXPECT_GT(distance, depth - tolerance * l0) << point.position.transpose();
      EXPECT_LT(distance, (D == 3 ? 1.81 : 1.51) * depth) << point.position.transpose();
    } else {
      EXPECT_NEAR(distance, depth, tolerance * l0) << point.position.transpose();
      EXPECT_NEAR(point.normal.norm(), 1, 1e-12);
    }
  }
}

/// Both have the same points, in any order.
template <int D>
void expect_same(std::vector<WallPoint<D>> a, std::vector<WallPoint<D>> b, double l0) {
  ASSERT_EQ(a.size(), b.size());
  const auto before = [&](const WallPoint<D>& p, const WallPoint<D>& q) {
    for (int axis = D - 1; axis >= 0; --axis)
      if (std::abs(p.position[axis] - q.position[axis]) > 1e-6 * l0) return p.position[axis] < q.position[axis];
    return false;
  };
  std::sort(a.begin(), a.end(), before);
  std::sort(b.begin(), b.end(), before);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_LT((a[k].position - b[k].position).norm(), 1e-12);
    EXPECT_LT((a[k].normal - b[k].normal).norm(), 1e-12) << a[k].position.transpose() / l0;
    EXPECT_NEAR(a[k].weight, b[k].weight, 1e-12) << a[k].position.transpose() / l0;
    EXPECT_EQ(a[k].layer, b[k].layer) << a[k].position.transpose() / l0;
  }
}

}  // namespace seiche::solver::test
