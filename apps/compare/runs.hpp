#pragma once
#include <functional>
#include <string>
#include <vector>

#include "apps/compare/plan.hpp"
#include "apps/compare/progress_table.hpp"
#include "apps/run/loop.hpp"

namespace seiche::apps::compare {

/// How a set of runs went.
struct Outcome {
  bool interrupted = false;
  std::vector<std::string> errors;  ///< one for each run that left no report, with its name
};

/// Runs those that aren't done yet, each as `seiche run` in a process of its own, as many at a time as cores and memory
/// allow. One that fails doesn't stop the others.
/// @param threads of all together
/// @param stop asked again and again; once it is true, runs end with their current frame and no other begins
Outcome run_all(const std::vector<PlannedRun>& runs, int threads, bool again, ProgressTable& table,
                const std::function<bool()>& stop);

/// How a stored run ended, as in "stopped at 0.229 s: 61 of 1200 fluid particles leaked through the walls"; parts: the
/// two halves of it.
std::vector<std::string> ending_lines(const Ending& ending);

}  // namespace seiche::apps::compare
