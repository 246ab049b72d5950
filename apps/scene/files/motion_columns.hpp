#pragma once
#include <string>
#include <vector>

#include "apps/common/csv.hpp"
#include "solver/parameters.hpp"

namespace seiche::apps {

/// Names with commas between, as in "sway, roll".
std::vector<std::string> listed(const std::string& names);

/// A record whose columns have titles, as `read_motion_file` has them. Throws BadScene.
/// @param wanted the columns that are followed; empty: all, and a title that isn't one of a motion is refused
Parameters::TimeSeries titled_motion(const Csv& table, const std::vector<std::string>& wanted);

}  // namespace seiche::apps
