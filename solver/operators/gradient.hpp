#pragma once
#include <Eigen/LU>
#include <algorithm>

#include "solver/particles/outer_sum.hpp"
#include "solver/particles/pairs.hpp"

namespace seiche::solver {

/// Equation (4) with its sign put right: grad f_i = (d/n0) sum_j (f_j - f_i) r_ij w/r_ij^2. First order only where the
/// neighbours lie symmetrically.
struct PlainGradient {};

/// (d/n0) sum_j (f_j - f_min,i) r_ij w/r_ij^2, f_min,i the least value at i and its neighbours: every pair repels
/// (Koshizuka, Nobe, Oka 1998).
struct MinimumGradient {};

/// C_i (1/n0) sum_j (f_j - f_i) r_ij w/r_ij^2 with C_i = ((1/n0) sum_j r_ij r_ij^T w/r_ij^2)^-1: exact on linear fields
/// (Khayyer & Gotoh 2011).
struct CorrectedGradient {};

/// Below this determinant of d M_i (1 on a full lattice, 1/4 at a flat free surface, 1/16 in a corner) the moment
/// matrix is held to be singular, and d stands for C_i.
inline constexpr double least_moment = 0.05;

namespace detail {

template <int D>
struct GradientSums {
  Vec<D> differences = Vec<D>::Zero();  ///< sum (f_j - f_i) r_ij w/r^2
  Vec<D> directions = Vec<D>::Zero();   ///< sum r_ij w/r^2
  OuterSum<D> moment;                   ///< sum r_ij r_ij^T w/r^2
  double least = 0;                     ///< f_min - f_i, at most 0

  void add(double weight, const Vec<D>& rij, double difference) {
    least = std::min(least, difference);
    differences += weight * difference * rij;
    directions += weight * rij;
    moment.add(weight * rij, rij);
  }

  /// A wall tells the slope across it, and nothing of the slope along it.
  void add_wall(double weight, const Vec<D>& rij, const Vec<D>& normal, const Vec<D>& slope) {
    const Vec<D> across = normal.isZero() ? rij : Vec<D>(normal.dot(rij) * normal);
    differences += weight * slope.dot(across) * across;
    directions += weight * across;
    moment.add(weight * across, across);
  }
};

template <int D>
Vec<D> combine(PlainGradient, const GradientSums<D>& s, double n0) {
  return D / n0 * s.differences;
}
template <int D>
Vec<D> combine(MinimumGradient, const GradientSums<D>& s, double n0) {
  return D / n0 * (s.differences - s.least * s.directions);
}
template <int D>
Vec<D> combine(CorrectedGradient, const GradientSums<D>& s, double n0) {
  const Eigen::Matrix<double, D, D> m = D / n0 * s.moment.matrix();
  const Vec<D> plain = D / n0 * s.differences;
  return m.determinant() > least_moment ? Vec<D>(m.inverse() * plain) : plain;
}

}  // namespace detail

/// Gradient of a pressure at fluid particles [Pa/m]; zero elsewhere. Dummies have no pressure and don't take part.
/// @param slope rho f at each fluid particle, the slope of the pressure across walls [Pa/m], which then stands for the
/// wall particles' pressures;
///        null: wall particles have pressures of their own
template <int D, class Model>
void pressure_gradient(Model model, const Pairs<D>& pairs, double n0, const Vecs<D>* slope, const State<D>& s,
                       Vecs<D>& out) {
  const int size = static_cast<int>(s.size());
#pragma omp parallel for schedule(static)
  for (int i = 0; i < size; ++i) {
    out[i].setZero();
    if (s.kind[i] != Kind::fluid) continue;
    detail::GradientSums<D> sums;
    pairs.each(i, s, [&](int j, const Vec<D>& rij, double weight) {
      weight *= s.wet[j];
      if (slope && s.kind[j] != Kind::fluid)
        sums.add_wall(weight, rij, s.normal_from(s.position[i], j), (*slope)[i]);
      else if (s.kind[j] != Kind::dummy)
        sums.add(weight, rij, s.pressure[j] - s.pressure[i]);
    });
    out[i] = detail::combine(model, sums, n0);
  }
}

}  // namespace seiche::solver
