#pragma once
#include <array>
#include <cmath>

#include "solver/parameters.hpp"

namespace seiche::physics {

/// Linear potential theory of a 2-D rectangular tank, length L, depth h, that rolls by theta(t) = A sin(w t) about
/// (xp, yp), water at rest in the lab at t = 0 (Faltinsen & Timokha, Sloshing, 2009, ch. 5; derived anew here).
///
/// In the lab the potential is Phi = theta' Psi + sum_n b_n cos(k_n x) cosh(k_n y)/cosh(k_n h), k_n = n pi/L. Psi is
/// the Stokes-Joukowski potential of the full box: on the walls Psi_x = -(y - yp), on the floor and at y = h
/// Psi_y = x - xp. With l_m = m pi/h and m odd
///   Psi = (x - xp)(y - yp) - (h - 2 yp)(x - L/2)
///         + sum_m 8 h/(m pi)^2 cos(l_m y) sinh(l_m (x - L/2))/(l_m cosh(l_m L/2)).
/// At y = h the surface rises over the tank by eta = sum_n beta_n cos(k_n x): beta_n' = b_n w_n^2/g (kinematic), and
/// Phi_t + g (eta + theta (x - xp)) = 0 (dynamic) gives, with the cosine coefficients X_n of x and Psi_n of Psi(x, h),
///   beta_n'' + w_n^2 beta_n = -w_n^2 (theta'' Psi_n/g + theta X_n),   X_n = -4 L/(n pi)^2,
///   Psi_n = yp X_n + 32 h/(L pi^2) sum_m 1/(m^2 (k_n^2 + l_m^2)),     n odd; both are 0 for n even.
/// The jump of theta' at t = 0 leaves Phi = 0 at y = h: b_n = -theta' Psi_n.
class RollTheory {
 public:
  explicit RollTheory(const Parameters& p)
      : length_(p.tank.length),
        depth_(p.fluid.depth),
        gravity_(p.gravity.size()),
        amplitude_(p.motion.harmonic.amplitude * M_PI / 180),
        w_(2 * M_PI * p.motion.harmonic.frequency),
        xp_(p.motion.pivot_x),
        yp_(p.motion.pivot_y) {}

  /// Displacement of the water's centre of mass along the tank [m]: -sum_n 2 beta_n/(k_n^2 h L).
  double centre(double t) const {
    double x = 0;
    for (int n = 1; n <= 41; n += 2) x -= 2 * beta(n, t) / (k(n) * k(n) * depth_ * length_);
    return x;
  }

  /// Velocity relative to the tank right after the start [m/s].
  std::array<double, 2> start(double x, double y) const {
    const double middle = x - length_ / 2;
    double u = -(depth_ - 2 * yp_) + (y - yp_), v = x - xp_;  // of Psi, for theta' = 1
    for (int m = 1; m <= 199; m += 2) {
      const double l = m * M_PI / depth_, c = 8 * depth_ / std::pow(m * M_PI, 2);
      const double right = std::exp(l * (middle - length_ / 2)), left = std::exp(-l * (middle + length_ / 2));
      const double whole = 1 + std::exp(-l * length_);
      u += c * std::cos(l * y) * (right + left) / whole;
      v -= c * std::sin(l * y) * (right - left) / whole;
    }
    for (int n = 1; n <= 199; n += 2) {
      const double decay = std::exp(k(n) * (y - depth_)) / (1 + std::exp(-2 * k(n) * depth_));
      u += psi(n) * k(n) * std::sin(k(n) * x) * decay * (1 + std::exp(-2 * k(n) * y));
      v -= psi(n) * k(n) * std::cos(k(n) * x) * decay * (1 - std::exp(-2 * k(n) * y));
    }
    // Less the tank's own velocity, theta' k x (r - pivot).
    return {amplitude_ * w_ * (u + (y - yp_)), amplitude_ * w_ * (v - (x - xp_))};
  }

 private:
  double k(int n) const { return n * M_PI / length_; }
  double x_coefficient(int n) const { return -4 * length_ / std::pow(n * M_PI, 2); }

  double psi(int n) const {
    double sum = 0;
    for (int m = 1; m <= 199; m += 2) sum += 1 / (m * m * (k(n) * k(n) + std::pow(m * M_PI / depth_, 2)));
    return yp_ * x_coefficient(n) + 32 * depth_ / (length_ * M_PI * M_PI) * sum;
  }

  double beta(int n, double t) const {
    const double wn2 = gravity_ * k(n) * std::tanh(k(n) * depth_), wn = std::sqrt(wn2);
    const double forced = wn2 * amplitude_ * (w_ * w_ * psi(n) / gravity_ - x_coefficient(n)) / (wn2 - w_ * w_);
    const double free = (-wn2 / gravity_ * amplitude_ * w_ * psi(n) - forced * w_) / wn;
    return forced * std::sin(w_ * t) + free * std::sin(wn * t);
  }

  double length_, depth_, gravity_, amplitude_, w_, xp_, yp_;
};

}  // namespace seiche::physics
