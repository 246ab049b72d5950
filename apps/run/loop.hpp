#pragma once
#include <functional>
#include <optional>
#include <string>

#include "apps/common/progress.hpp"
#include "apps/run/outputs.hpp"
#include "solver/errors.hpp"
#include "solver/simulation.hpp"

namespace seiche::apps {

/// How a run ended.
struct Ending {
  enum class Status { finished, failed, interrupted };
  Status status = Status::finished;
  std::optional<Failure> failure;  ///< of the simulation
  std::string error;               ///< of the outputs, or anything else that isn't the simulation's
  long frames = 0;                 ///< handed to every sink
  double time = 0;                 ///< simulated [s]
  double waited = 0;               ///< for the outputs, with nothing else to do: wall-clock [s]

  /// Why it failed, as in "stopped at t = 0.0190 s, step 36: ...; the disk is full"; empty where it didn't.
  std::string reason() const;
};

/// As in "finished".
std::string name(Ending::Status status);

/// Steps the simulation from frame to frame and hands each to the outputs, the first at t = 0, the last at the end;
/// they work on a thread of their own. Of a simulation that fails, the state that it broke off in is the last frame, if
/// its values are finite. A failed output ends the run within a step. Whatever happens, the outputs take
/// the frames that are there, and are ended.
/// @param stop asked after each step; once it is true the run ends with the current frame
Ending run_loop(Simulation& simulation, Outputs& outputs, const RunInfo& run, Progress& progress,
                const std::function<bool()>& stop);

}  // namespace seiche::apps
