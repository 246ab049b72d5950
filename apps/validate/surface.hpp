#pragma once
#include <vector>

#include "apps/validate/series.hpp"
#include "solver/frame.hpp"

namespace seiche::validate {

/// Middles of `count` equal parts of a tank's length [m].
std::vector<double> stations(double length, int count);

/// Height of the surface above the floor at each x of a 2-D frame [m], as a wave gauge there would read it.
std::vector<double> surface_heights(const Frame& frame, const RunInfo& run, const std::vector<double>& x);

/// How far the water reaches to the right [m]: the greatest x of fluid with two other fluid particles within 1.5 l0,
/// and half a spacing. Drops that fly ahead alone or in pairs don't count.
double front(const Frame& frame, double spacing);

/// Sums of squares of z_series - z_reference over the points of `series` in [from, to], as distances between profiles.
struct ProfileDistance {
  double squares = 0;
  long count = 0;
};
ProfileDistance profile_distance(const Series& reference, const Series& series, double from, double to);

}  // namespace seiche::validate
