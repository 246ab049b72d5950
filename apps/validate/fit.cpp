#include "apps/validate/fit.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>

namespace seiche::apps::validate {

double order(const std::vector<double>& spacings, const std::vector<double>& errors) {
  const auto n = static_cast<Eigen::Index>(spacings.size());
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(spacings.data(), n).log();
  const Eigen::ArrayXd y = Eigen::Map<const Eigen::ArrayXd>(errors.data(), n).log();
  return ((x - x.mean()) * (y - y.mean())).sum() / (x - x.mean()).square().sum();
}

double Oscillation::at(double t) const { return amplitude * std::exp(-decay * t) * std::cos(omega * t + phase); }

Oscillation fit_oscillation(const Series& series, double omega) {
  const auto n = static_cast<Eigen::Index>(series.size());
  const Eigen::ArrayXd t = Eigen::Map<const Eigen::ArrayXd>(series.t.data(), n);
  const Eigen::VectorXd y = Eigen::Map<const Eigen::VectorXd>(series.y.data(), n);
  double decay = 0;
  for (int pass = 0; pass < 50; ++pass) {
    // Columns: the two phases, then the derivatives of their sum by decay and omega.
    const Eigen::ArrayXd envelope = (-decay * t).exp();
    Eigen::MatrixXd m(n, 4);
    m.col(0) = envelope * (omega * t).cos();
    m.col(1) = envelope * (omega * t).sin();
    const Eigen::Vector2d phases = m.leftCols<2>().householderQr().solve(y);
    m.col(2) = -t * (phases[0] * m.col(0) + phases[1] * m.col(1)).array();
    m.col(3) = t * (phases[1] * m.col(0) - phases[0] * m.col(1)).array();
    const Eigen::VectorXd change = m.householderQr().solve(y - m.leftCols<2>() * phases);
    decay += change[2];
    omega += change[3];
    if (!std::isfinite(decay + omega)) break;
    if (std::abs(change[2]) + std::abs(change[3]) < 1e-10 * omega)
      return {phases.norm(), decay, omega, std::atan2(-phases[1], phases[0])};
  }
  throw std::runtime_error("no damped oscillation fits the series");
}

}  // namespace seiche::apps::validate
