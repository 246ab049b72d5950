#pragma once
#include <array>
#include <cmath>

namespace seiche {

/// The most that a scene may have [m/s^2].
constexpr double greatest_gravity = 100;

/// Gravity in the tank's axes as they are at t = 0 [m/s^2]. A tank that stands upright has it along -y; in one that
/// leans it has other parts, too, and the liquid starts with its surface square to it.
class Gravity {
 public:
  Gravity() = default;

  /// Along -y.
  Gravity(double size) : parts_{0, -size, 0} {}

  explicit Gravity(const std::array<double, 3>& parts) : parts_(parts) {}

  double operator[](std::size_t axis) const { return parts_[axis]; }

  /// 0: there is none.
  double size() const { return std::hypot(parts_[0], parts_[1], parts_[2]); }

  /// Whether it points along -y, or there is none.
  bool is_upright() const { return parts_[0] == 0 && parts_[2] == 0 && parts_[1] <= 0; }

  bool operator==(const Gravity&) const = default;

 private:
  std::array<double, 3> parts_{0, -9.81, 0};
};

}  // namespace seiche
