#pragma once
#include "apps/common/series.hpp"
#include "solver/parameters.hpp"

namespace seiche::apps::validate {

/// omega of mode n of the liquid at rest in the tank [1/s]: omega^2 = g k tanh(k h), k = n pi/L.
double natural_frequency(const Parameters& p, int n);

/// Linear potential theory of a rectangular tank that rolls by theta(t), counted from x towards y, about a pivot.
///
/// In the lab Phi = theta' Psi + sum_n B_n cos(k_n x) cosh(k_n y)/cosh(k_n h), where Psi carries the walls' velocity
/// with the surface as a lid (Stokes, Joukowski): Psi_x = -(y - y_p) at the sides, Psi_y = x - x_p at floor and lid, so
/// that
///   Psi = -(x - L/2)(y - y_p) + (L/2 - x_p) y - sum 2 c_n sinh k_n(y - h/2)/(k_n cosh(k_n h/2)) cos(k_n x).
/// With the elevation over the tank's own still level eta = sum beta_n cos(k_n x), the surface gives
///   beta_n' = (omega_n^2/g) B_n,  B_n' = -g beta_n + c_n g theta - psi_n theta'',
///   psi_n = c_n (h - y_p - 2 tanh(k_n h/2)/k_n),  c_n = 4 L/(n pi)^2,  n odd.
/// The roll is theta = A sin(omega t) and starts impulsively with the surface flat in the tank: Phi = 0 on the surface,
/// hence B_n(0) = -psi_n theta'(0). Then beta_n = P_n sin(omega t) + S_n sin(omega_n t).
/// Cf. O.M. Faltinsen, A.N. Timokha, Sloshing, Cambridge University Press, 2009, chapter 5.
/// @returns elevation at the left wall [m], the opposite of the right wall's, every `step` to `end` [s].
/// Throws std::invalid_argument for another motion.
Series roll_elevation(const Parameters& p, double step, double end);

}  // namespace seiche::apps::validate
