#include "tests/unit/solver/cloud.hpp"

namespace seiche::solver::test {

template <int D>
State<D> block(int cells, double spacing) {
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
State<D> disordered(State<D> s, double amount) {
  std::mt19937_64 random(7);
  for (auto& r : s.position) r += random_vec<D>(random, -amount, amount);
  return s;
}

template <int D>
State<D> random_cloud(int size, double low, double high, int seed) {
  std::mt19937_64 random(seed);
  State<D> s;
  for (int i = 0; i < size; ++i) s.add(random_vec<D>(random, low, high), Kind::fluid, Vec<D>::Zero());
  return s;
}

template <int D>
Neighbours<D> listed(State<D>& s, double radius, double skin) {
  Vec<D> low = s.position.at(0), high = low;
  for (const auto& r : s.position) {
    low = low.cwiseMin(r);
    high = high.cwiseMax(r);
  }
  Neighbours<D> list(low, high, radius, skin);
  list.build(s);
  return list;
}

template <int D>
int nearest(const State<D>& s, const Vec<D>& point) {
  int best = 0;
  for (int i = 0; i < static_cast<int>(s.size()); ++i)
    if ((s.position[i] - point).squaredNorm() < (s.position[best] - point).squaredNorm()) best = i;
  return best;
}

template State<2> block(int, double);
template State<2> disordered(State<2>, double);
template State<2> random_cloud(int, double, double, int);
template Neighbours<2> listed(State<2>&, double, double);
template int nearest(const State<2>&, const Vec<2>&);
template State<3> block(int, double);
template State<3> disordered(State<3>, double);
template State<3> random_cloud(int, double, double, int);
template Neighbours<3> listed(State<3>&, double, double);
template int nearest(const State<3>&, const Vec<3>&);

}  // namespace seiche::solver::test
