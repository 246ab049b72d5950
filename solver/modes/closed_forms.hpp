#pragma once
#include <vector>

// Linear waves in a tank that is still, where the potential separates: omega^2 = g k tanh(k h) (Lamb 1932, art. 228
// and 257; Ibrahim 2005, ch. 1). All throw BadParameters for a length or a gravity that isn't greater than 0.
namespace seiche::solver::modes {

/// The lowest angular frequencies of a box [rad/s], ascending: k^2 is the sum of (n pi / side)^2, n = 0, 1, ... not all
/// 0.
/// @param sides of the still surface, one in 2-D or two in 3-D [m]
/// @param depth [m]
/// @param gravity [m/s^2]
std::vector<double> box_frequencies(const std::vector<double>& sides, double depth, double gravity, int count);

/// The lowest angular frequencies of an upright circular cylinder with a flat floor [rad/s], ascending: k R are the
/// zeros of J_m', m = 0, 1, ...; waves that differ by a turn alone count once. The lowest has m = 1, k R = 1.841184.
/// @param radius R, @param depth [m]
/// @param gravity [m/s^2]
std::vector<double> upright_cylinder_frequencies(double radius, double depth, double gravity, int count);

/// The first zeros x > 0 of J_m', ascending.
std::vector<double> bessel_slope_zeros(int m, int count);

}  // namespace seiche::solver::modes
