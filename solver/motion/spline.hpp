#pragma once
#include <vector>

namespace seiche::solver {

/// A quantity and its first two derivatives in time.
struct Jet {
  double value = 0, rate = 0, acceleration = 0;
};

/// The cubic spline through samples, twice continuously differentiable, with the not-a-knot condition at both ends (de
/// Boor, A Practical Guide to Splines, 1978, ch. IV). With an interval h its value is good to O(h^4), its rate to
/// O(h^3), its acceleration to O(h^2), up to both ends; cubics are exact. Beyond the ends it goes on as its last cubic.
class Spline {
 public:
  /// @param x ascending; four at least, as many as y
  Spline(std::vector<double> x, std::vector<double> y);

  Jet at(double x) const;

  double first() const { return x_.front(); }
  double last() const { return x_.back(); }
  std::size_t size() const { return x_.size(); }

 private:
  std::vector<double> x_, y_, second_;  ///< samples, and the second derivative at each
};

}  // namespace seiche::solver
