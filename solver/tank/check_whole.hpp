#pragma once

namespace seiche::solver {

/// Whether the length is a whole number of spacings l0, to rounding.
bool is_whole(double length, double l0);

/// Throws BadParameters unless the length is a whole number of spacings l0, four at least.
/// @param key of the scene, for the message
void check_whole(const char* key, double length, double l0);

}  // namespace seiche::solver
