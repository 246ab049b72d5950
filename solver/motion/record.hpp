#pragma once
#include <vector>

// What a measured record needs before it can move a tank. Times ascend; there are as many values as times, four at
// least.
namespace seiche::solver {

/// The unit g of accelerations (CGPM 1901) [m/s^2].
constexpr double standard_gravity = 9.80665;

/// Angles [degrees] without jumps of whole turns: those between neighbours that pass 180 degrees.
std::vector<double> unwrapped(std::vector<double> angles);

/// The displacement of an acceleration: the integral, twice, of the spline through it, exact between samples, less the
/// parabola in t that comes nearest to that over the record (least squares over time). So an unknown velocity at the
/// start and a constant error of the gauge leave no drift; nor does what really moved so.
std::vector<double> integrated_twice(const std::vector<double>& time, const std::vector<double>& acceleration);

/// The natural cubic spline f that makes the integrals of (y - f)^2 + f''^2/(2 pi cutoff)^4 over time least (Reinsch
/// 1967), at the samples. What is far slower than it could change from sample to sample keeps 1/(1 + (f/cutoff)^4) of
/// its amplitude at a frequency f, and all of its phase.
/// @param cutoff [Hz]
std::vector<double> smoothed(const std::vector<double>& time, const std::vector<double>& values, double cutoff);

/// The largest number that all differences between values are whole multiples of, to a millionth of their range; 0 if
/// all are equal. It is what a record was rounded to.
double resolution(const std::vector<double>& values);

/// The RMS acceleration that a record has by the rounding of its values and times alone, both evenly spread over their
/// resolution q: sqrt(3) q/h^2 of the spline through samples h apart in the mean, and no more than
/// (2 pi cutoff)^2 q sqrt(h cutoff pi sqrt(2)/96) once it is smoothed; of times q is that in them times the RMS rate,
/// where the intervals differ.
/// @param cutoff of `smoothed` [Hz]; 0: it wasn't
double rounding_acceleration(const std::vector<double>& time, const std::vector<double>& values, double cutoff);

}  // namespace seiche::solver
