#pragma once
#include <vector>

#include "apps/validate/bench.hpp"

namespace seiche::apps::validate {

/// Middles of `count` equal parts of a tank's length [m].
std::vector<double> stations(double length, int count);

/// The surface over the recording's stations at a time: its height above the floor over x [m].
Series profile(const Recording& recording, double time);

/// Mean over the stations and the times of [from, to] of the surface's height above the floor [m].
double mean_height(const Recording& recording, double from, double to);

/// How far the water reaches to the right [m]: the greatest x of fluid with two other fluid particles within 1.5 l0,
/// and half a spacing. Drops that fly ahead alone or in pairs don't count.
double front(const Frame& frame, double spacing);

/// Sums of squares of z_series - z_reference over the points of `series` in [from, to], as distances between profiles.
struct ProfileDistance {
  double squares = 0;
  long count = 0;
};
ProfileDistance profile_distance(const Series& reference, const Series& series, double from, double to);

}  // namespace seiche::apps::validate
