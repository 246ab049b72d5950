#pragma once
#include <string>
#include <vector>

#include "solver/run_info.hpp"

namespace seiche::render {

/// No more runs than this find room in one picture, or colours for their curves.
constexpr std::size_t most_panels = 9;

/// One of the runs that are shown under one clock.
struct Variant {
  RunInfo run;
  std::string label;                 ///< above its panel, as in "KF3, 5 mm"
  std::vector<std::string> message;  ///< lines over its panel once its frames have ended, as in "stopped at 0.229 s"
  bool failed = false;
};

}  // namespace seiche::render
