#pragma once
#include <string>

#include "solver/parameters.hpp"

namespace seiche::apps {

/// Reads a motion: CSV with a header of columns, in any order, of `t [s]` and one at least of `surge [m]`, `heave [m]`,
/// `roll [deg]`; also in ms, cm, mm, rad. At least four samples, times ascending, no gaps. Throws BadScene with
/// file:line, what is wrong and what was expected.
Parameters::TimeSeries read_motion_file(const std::string& file);

/// The same from a file's text; `file` is its name in messages.
Parameters::TimeSeries parse_motion(const std::string& text, const std::string& file);

}  // namespace seiche::apps
