#include "solver/motion/spline.hpp"

#include <algorithm>
#include <cassert>

namespace seiche::solver {

// The second derivatives M solve h0 M0 + 2 (h0 + h1) M1 + h1 M2 = 6 (slope1 - slope0) at each inner sample; the ends'
// are the straight lines through those of their two neighbours, which is what not-a-knot says.
Spline::Spline(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)), second_(x_.size()) {
  assert(x_.size() >= 4 && x_.size() == y_.size());
  const std::size_t n = x_.size();
  const auto h = [&](std::size_t k) { return x_[k + 1] - x_[k]; };
  const auto slope = [&](std::size_t k) { return (y_[k + 1] - y_[k]) / h(k); };
  std::vector<double> upper(n);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double left = h(k - 1), right = h(k);
    double below = left, diagonal = 2 * (left + right), above = right;
    if (k == 1) {
      diagonal += left * (left + right) / right;
      above -= left * left / right;
      below = 0;
    }
    if (k + 2 == n) {
      diagonal += right * (left + right) / left;
      below -= right * right / left;
      above = 0;
    }
    const double pivot = diagonal - below * upper[k - 1];
    upper[k] = above / pivot;
    second_[k] = (6 * (slope(k) - slope(k - 1)) - below * second_[k - 1]) / pivot;
  }
  for (std::size_t k = n - 3; k >= 1; --k) second_[k] -= upper[k] * second_[k + 1];
  second_[0] = second_[1] - h(0) / h(1) * (second_[2] - second_[1]);
  second_[n - 1] = second_[n - 2] + h(n - 2) / h(n - 3) * (second_[n - 2] - second_[n - 3]);
}

Jet Spline::at(double x) const {
  const auto above = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const std::size_t k = static_cast<std::size_t>(above - x_.begin()) - 1;
  const double h = x_[k + 1] - x_[k], a = (x_[k + 1] - x) / h, b = 1 - a;
  const double m0 = second_[k], m1 = second_[k + 1];
  return {a * y_[k] + b * y_[k + 1] + ((a * a * a - a) * m0 + (b * b * b - b) * m1) * h * h / 6,
          (y_[k + 1] - y_[k]) / h + ((1 - 3 * a * a) * m0 + (3 * b * b - 1) * m1) * h / 6, a * m0 + b * m1};
}

}  // namespace seiche::solver
