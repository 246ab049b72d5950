#include "solver/motion/record.hpp"

#include <Eigen/Dense>
#include <Eigen/Sparse>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/motion/spline.hpp"

namespace seiche::solver {
namespace {

/// The part of the time that each sample stands for, by the trapezoidal rule.
std::vector<double> weights(const std::vector<double>& time) {
  const std::size_t n = time.size();
  std::vector<double> all(n);
  for (std::size_t k = 0; k < n; ++k) all[k] = 0.5 * (time[std::min(k + 1, n - 1)] - time[k > 0 ? k - 1 : 0]);
  return all;
}

double rms_rate(const std::vector<double>& time, const std::vector<double>& values) {
  double sum = 0;
  for (std::size_t k = 1; k < time.size(); ++k)
    sum += (values[k] - values[k - 1]) * (values[k] - values[k - 1]) / (time[k] - time[k - 1]);
  return std::sqrt(sum / (time.back() - time.front()));
}

}  // namespace

std::vector<double> unwrapped(std::vector<double> angles) {
  for (std::size_t k = 1; k < angles.size(); ++k) angles[k] -= 360 * std::round((angles[k] - angles[k - 1]) / 360);
  return angles;
}

std::vector<double> integrated_twice(const std::vector<double>& time, const std::vector<double>& acceleration) {
  const Spline spline(time, acceleration);
  const auto n = static_cast<Eigen::Index>(time.size());
  Eigen::VectorXd displacement(n);
  double velocity = 0;
  displacement[0] = 0;
  double curvature = spline.at(time[0]).acceleration;
  for (std::size_t k = 0; k + 1 < time.size(); ++k) {
    const double h = time[k + 1] - time[k], a = acceleration[k], b = acceleration[k + 1];
    const double next = spline.at(time[k + 1]).acceleration;
    const auto at = static_cast<Eigen::Index>(k);
    displacement[at + 1] =
        displacement[at] + h * velocity + h * h * (2 * a + b) / 6 - h * h * h * h * (8 * curvature + 7 * next) / 360;
    velocity += h * (a + b) / 2 - h * h * h * (curvature + next) / 24;
    curvature = next;
  }
  const std::vector<double> weight = weights(time);
  const double middle = 0.5 * (time.front() + time.back()), half = 0.5 * (time.back() - time.front());
  Eigen::MatrixXd powers(n, 3);
  Eigen::VectorXd weighted(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double root = std::sqrt(weight[at]), t = (time[at] - middle) / half;
    powers.row(k) << root, root * t, root * t * t;
    weighted[k] = root * displacement[k];
  }
  const Eigen::Vector3d drift = powers.colPivHouseholderQr().solve(weighted);
  std::vector<double> result(time.size());
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double t = (time[k] - middle) / half;
    result[k] = displacement[static_cast<Eigen::Index>(k)] - drift[0] - drift[1] * t - drift[2] * t * t;
  }
  return result;
}

/// Second derivatives g at the inner samples solve (R + lambda Q^T W^-1 Q) g = Q^T y, Q^T the second differences, R the
/// tridiagonal matrix of the spline, W the weights; f = y - lambda W^-1 Q g.
std::vector<double> smoothed(const std::vector<double>& time, const std::vector<double>& values, double cutoff) {
  const double omega = 2 * std::numbers::pi * cutoff, lambda = 1 / (omega * omega * omega * omega);
  const auto n = static_cast<Eigen::Index>(time.size());
  const std::vector<double> weight = weights(time);
  std::vector<Eigen::Triplet<double>> differences, spline;
  const auto h = [&](Eigen::Index k) {
    return time[static_cast<std::size_t>(k) + 1] - time[static_cast<std::size_t>(k)];
  };
  for (Eigen::Index k = 1; k + 1 < n; ++k) {
    differences.emplace_back(k - 1, k - 1, 1 / h(k - 1));
    differences.emplace_back(k - 1, k, -1 / h(k - 1) - 1 / h(k));
    differences.emplace_back(k - 1, k + 1, 1 / h(k));
    spline.emplace_back(k - 1, k - 1, (h(k - 1) + h(k)) / 3);
    if (k + 2 < n) {
      spline.emplace_back(k - 1, k, h(k) / 6);
      spline.emplace_back(k, k - 1, h(k) / 6);
    }
  }
  Eigen::SparseMatrix<double> q(n - 2, n), r(n - 2, n - 2);
  q.setFromTriplets(differences.begin(), differences.end());
  r.setFromTriplets(spline.begin(), spline.end());
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(values.data(), n);
  const Eigen::VectorXd inverse = Eigen::Map<const Eigen::VectorXd>(weight.data(), n).cwiseInverse();
  const Eigen::SparseMatrix<double> weighted = q * inverse.asDiagonal(), transposed = q.transpose();
  const Eigen::SparseMatrix<double> roughness = weighted * transposed, system = r + lambda * roughness;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(system);
  const Eigen::VectorXd second = factor.solve(q * y);
  const Eigen::VectorXd f = y - lambda * inverse.cwiseProduct(q.transpose() * second);
  return {f.begin(), f.end()};
}

/// Euclid's algorithm over the differences of the sorted values.
double resolution(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const double tolerance = 1e-6 * (sorted.back() - sorted.front());
  double common = 0;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    double a = common, b = sorted[k] - sorted[k - 1];
    while (b > tolerance) {
      const double rest = a == 0 ? 0 : std::abs(std::remainder(a, b));
      a = b;
      b = rest;
    }
    common = a;
  }
  return common;
}

double rounding_acceleration(const std::vector<double>& time, const std::vector<double>& values, double cutoff) {
  const double h = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  std::vector<double> intervals;
  for (std::size_t k = 1; k < time.size(); ++k) intervals.push_back(time[k] - time[k - 1]);
  const auto [least, most] = std::minmax_element(intervals.begin(), intervals.end());
  // What is left after the rounding of decimals to binary numbers is no difference.
  const double of_times = *most - *least > 1e-6 * h ? resolution(intervals) * rms_rate(time, values) : 0;
  const double q = std::hypot(resolution(values), of_times);
  const double all = std::sqrt(3) * q / (h * h);
  if (cutoff <= 0) return all;
  const double omega = 2 * std::numbers::pi * cutoff;
  return std::min(all, omega * omega * q * std::sqrt(h * cutoff * std::numbers::pi * std::numbers::sqrt2 / 96));
}

}  // namespace seiche::solver
