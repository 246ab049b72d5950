#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "solver/particles/pairs.hpp"

// Clouds of particles for the tests of one operator at a time.
namespace seiche::solver::test {

inline constexpr double l0 = 0.01;

template <int N>
struct Dimension {
  static constexpr int D = N;
};
using Dimensions = ::testing::Types<Dimension<2>, Dimension<3>>;

/// A lattice of cells^D fluid particles centred on the origin; an odd number puts one there.
template <int D>
State<D> block(int cells, double spacing = l0) {
  State<D> s;
  Eigen::Matrix<int, D, 1> c = Eigen::Matrix<int, D, 1>::Zero();
  while (c[D - 1] < cells) {
    const Vec<D> centred = c.template cast<double>().array() - 0.5 * (cells - 1);
    s.add(spacing * centred, Kind::fluid, Vec<D>::Zero());
    for (int a = 0; ++c[a] == cells && a < D - 1; ++a) c[a] = 0;
  }
  return s;
}

template <int D>
Vec<D> random_vec(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  Vec<D> v;
  for (int a = 0; a < D; ++a) v[a] = uniform(random);
  return v;
}

/// Moves every particle by up to `amount` on each axis, always in the same way.
template <int D>
State<D> disordered(State<D> s, double amount) {
  std::mt19937_64 random(7);
  for (auto& r : s.position) r += random_vec<D>(random, -amount, amount);
  return s;
}

/// Fluid particles anywhere between low and high on each axis.
template <int D>
State<D> random_cloud(int size, double low, double high, int seed = 1) {
  std::mt19937_64 random(seed);
  State<D> s;
  for (int i = 0; i < size; ++i) s.add(random_vec<D>(random, low, high), Kind::fluid, Vec<D>::Zero());
  return s;
}

/// Sorts the state and lists its pairs within `radius`; set fields after that.
template <int D>
Neighbours<D> listed(State<D>& s, double radius, double skin = 0) {
  Vec<D> low = s.position.at(0), high = low;
  for (const auto& r : s.position) {
    low = low.cwiseMin(r);
    high = high.cwiseMax(r);
  }
  Neighbours<D> list(low, high, radius, skin);
  list.build(s);
  return list;
}

/// The listed pairs within the kernel's support, at the present positions.
template <int D, class K>
Pairs<D> measured(const K& w, const Neighbours<D>& list, const State<D>& s) {
  Pairs<D> pairs;
  pairs.measure(w, list, s);
  return pairs;
}

/// Index of the particle nearest to a point.
template <int D>
int nearest(const State<D>& s, const Vec<D>& point) {
  int best = 0;
  for (int i = 0; i < static_cast<int>(s.size()); ++i)
    if ((s.position[i] - point).squaredNorm() < (s.position[best] - point).squaredNorm()) best = i;
  return best;
}

/// Greatest coordinate, on any axis, of a particle of a centred block.
template <int D>
double reach(const Vec<D>& r) {
  return r.cwiseAbs().maxCoeff();
}

/// 1, 2, 3 along the axes: a direction that favours none.
template <int D>
Vec<D> slanted() {
  return Vec<D>::LinSpaced(1, D);
}

}  // namespace seiche::solver::test
