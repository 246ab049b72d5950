#pragma once
#include <gtest/gtest.h>

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
State<D> block(int cells, double spacing = l0);

template <int D>
Vec<D> random_vec(std::mt19937_64& random, double low, double high) {
  std::uniform_real_distribution<double> uniform(low, high);
  Vec<D> v;
  for (int a = 0; a < D; ++a) v[a] = uniform(random);
  return v;
}

/// Moves every particle by up to `amount` on each axis, always in the same way.
template <int D>
State<D> disordered(State<D> s, double amount);

/// Fluid particles anywhere between low and high on each axis.
template <int D>
State<D> random_cloud(int size, double low, double high, int seed = 1);

/// Sorts the state and lists its pairs within `radius`; set fields after that.
template <int D>
Neighbours<D> listed(State<D>& s, double radius, double skin = 0);

/// The listed pairs within the kernel's support, at the present positions.
template <int D, class K>
Pairs<D> measured(const K& w, const Neighbours<D>& list, const State<D>& s) {
  Pairs<D> pairs;
  pairs.measure(w, list, s);
  return pairs;
}

/// Index of the particle nearest to a point.
template <int D>
int nearest(const State<D>& s, const Vec<D>& point);

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
