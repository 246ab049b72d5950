#pragma once
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <utility>
#include <vector>

#include "solver/kernels.hpp"
#include "solver/motion.hpp"
#include "solver/parameters.hpp"
#include "solver/state.hpp"

namespace seiche::solver {

/// Pressure at a point of the wall [Pa]: the linear function that fits the fluid within 3 l0 best (weighted least
/// squares), at the point. Exact on a hydrostatic field wherever the neighbours span space; their weighted mean where
/// they don't; 0 where there is no fluid.
template <int D>
double pressure_at(const Vec<D>& point, double l0, const State<D>& s) {
  const KF3 w{3 * l0};
  using Row = Eigen::Matrix<double, D + 1, 1>;
  Eigen::Matrix<double, D + 1, D + 1> normal = Eigen::Matrix<double, D + 1, D + 1>::Zero();
  Row right = Row::Zero();
  for (std::size_t j = 0; j < s.size(); ++j) {
    if (s.kind[j] != Kind::fluid) continue;
    const Vec<D> offset = s.position[j] - point;
    const double r = offset.norm();
    if (!(r < w.support)) continue;
    Row row;
    row << 1, offset / l0;
    normal += w(r) * row * row.transpose();
    right += w(r) * s.pressure[j] * row;
  }
  if (normal(0, 0) == 0) return 0;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D + 1, D + 1>> spectrum(normal);
  // 1e-3 of the greatest: below it the neighbours lie nearly in a line (plane) and a slope would be noise.
  if (spectrum.eigenvalues()[0] < 1e-3 * spectrum.eigenvalues()[D]) return right[0] / normal(0, 0);
  return normal.ldlt().solve(right)[0];
}

/// Height of the water surface above the floor at x (and z) [m]: the highest crossing of half the fluid fraction
///   phi(y) = sum_fluid w l0^D / (integral of w - sum_wall w l0^D),
/// w being KF3 of support 2 l0, so that a wall beside the gauge takes nothing away. Spray, fluid with fewer than two
/// fluid neighbours within 1.5 l0, doesn't count. 0 where there is no water.
template <int D>
class WaveGauge {
 public:
  WaveGauge(const Vec<D>& foot, double height, double l0) : foot_(foot), height_(height), l0_(l0), w_{2 * l0} {
    // The sum over a lattice about a corner of its cells stands for the integral of w: pi/5 r_e^2 in 2-D.
    const int m = 2;
    for (int k = D == 3 ? -m : 0; k <= (D == 3 ? m : 0); ++k)
      for (int j = -m; j <= m; ++j)
        for (int i = -m; i <= m; ++i)
          whole_ +=
              w_(l0 * std::sqrt((i + 0.5) * (i + 0.5) + (j + 0.5) * (j + 0.5) + (D == 3 ? (k + 0.5) * (k + 0.5) : 0)));
  }

  double level(const State<D>& s) {
    strip_.clear();
    double top = 0;
    for (std::size_t j = 0; j < s.size(); ++j) {
      Vec<D> across = s.position[j] - foot_;
      across[1] = 0;
      if (!(across.squaredNorm() < w_.support * w_.support)) continue;
      strip_.push_back(static_cast<int>(j));
    }
    water_.clear();
    for (int j : strip_)
      if (!is_spray(s, j)) water_.push_back(j);
    for (int j : water_)
      if (s.kind[j] == Kind::fluid) top = std::max(top, s.position[j][1]);
    const double dy = 0.25 * l0_;
    double y = std::min(top + w_.support, height_), above = fraction(s, y);
    if (above >= 0.5) return y;
    while (y > 0) {
      y -= dy;
      const double below = fraction(s, y);
      if (below >= 0.5) return y + dy * (below - 0.5) / (below - above);
      above = below;
    }
    return 0;
  }

 private:
  bool is_spray(const State<D>& s, int i) const {
    if (s.kind[i] != Kind::fluid) return false;
    const auto close = [&](int j) {
      return j != i && s.kind[j] == Kind::fluid && (s.position[j] - s.position[i]).norm() < 1.5 * l0_;
    };
    return std::count_if(strip_.begin(), strip_.end(), close) < 2;
  }

  double fraction(const State<D>& s, double y) const {
    Vec<D> point = foot_;
    point[1] = y;
    double fluid = 0, solid = 0;
    for (int j : water_) (s.kind[j] == Kind::fluid ? fluid : solid) += w_((s.position[j] - point).norm());
    return fluid / std::max(whole_ - solid, 0.1 * whole_);
  }

  Vec<D> foot_;
  double height_, l0_;
  KF3 w_;
  double whole_ = 0;
  std::vector<int> strip_, water_;  ///< particles around the gauge's line, and those of them that aren't spray
};

/// The sensors of a run, read at exact multiples of the sample interval by linear interpolation between steps, and the
/// tank's motion as it is at those times.
template <int D>
class Sensors {
 public:
  Sensors(const Parameters& p, double interval)
      : interval_(interval), spacing_(p.particles.spacing), still_level_(p.fluid.depth), motion_(p.motion) {
    Vec<D> left = Vec<D>::Zero();
    if constexpr (D == 3) left[2] = 0.5 * p.tank.width;
    Vec<D> right = left;
    right[0] = p.tank.length;
    corner_ = left;
    gauges_ = {WaveGauge<D>(left, p.tank.height, spacing_), WaveGauge<D>(right, p.tank.height, spacing_)};
  }

  /// Call with the state at t = 0 and after each step.
  void read(const State<D>& s) {
    if (interval_ <= 0) return;
    std::vector<double> now{pressure_at<D>(corner_, spacing_, s)};
    for (auto& gauge : gauges_) now.push_back(gauge.level(s) - still_level_);
    for (double t; (t = next_ * interval_) <= s.time * (1 + 1e-12); ++next_) {
      readings_.time.push_back(t);
      const double share = s.time > last_time_ ? (t - last_time_) / (s.time - last_time_) : 1;
      for (std::size_t k = 0; k < now.size(); ++k)
        readings_.values.push_back(last_.empty() ? now[k] : last_[k] + share * (now[k] - last_[k]));
      motion_.append(t, readings_.values);
    }
    last_ = std::move(now);
    last_time_ = s.time;
  }

  /// Readings since the last call.
  Readings take() { return std::exchange(readings_, {}); }

 private:
  double interval_, spacing_, still_level_;
  Motion motion_;
  Vec<D> corner_;
  std::vector<WaveGauge<D>> gauges_;
  Readings readings_;
  std::vector<double> last_;
  double last_time_ = 0;
  long next_ = 0;
};

}  // namespace seiche::solver
