#include "apps/loop.hpp"

#include <cmath>

#include "apps/stopwatch.hpp"

namespace seiche::apps {
namespace {

// A last interval shorter than this share of one is rounding, not a frame.
constexpr double sliver = 1e-6;

long last_frame(const RunInfo& run) { return std::lround(std::ceil(run.end / run.frame_interval - sliver)); }

// The loop itself; throws what the simulation and the sinks throw.
Ending::Status step_through(Simulation& simulation, Outputs& outputs, const RunInfo& run, Progress& progress,
                            const std::function<bool()>& stop, long& frames) {
  const Stopwatch watch;
  const long last = last_frame(run);
  outputs.begin(run);
  for (long k = 0; k <= last; ++k) {
    const double target = k == last ? run.end : k * run.frame_interval;
    while (simulation.time() < target) {
      simulation.step(target);
      progress.show({simulation.time(), run.end, k, last, simulation.statistics().steps, watch.seconds(), stop()});
    }
    outputs.frame(simulation.frame(k));
    frames = k + 1;
    if (k < last && stop()) return Ending::Status::interrupted;
  }
  return Ending::Status::finished;
}

}  // namespace

std::string name(Ending::Status status) {
  switch (status) {
    case Ending::Status::finished:
      return "finished";
    case Ending::Status::failed:
      return "failed";
    case Ending::Status::interrupted:
      return "interrupted";
  }
  return {};
}

Ending run_loop(Simulation& simulation, Outputs& outputs, const RunInfo& run, Progress& progress,
                const std::function<bool()>& stop) {
  Ending ending;
  try {
    ending.status = step_through(simulation, outputs, run, progress, stop, ending.frames);
  } catch (const std::exception& error) {
    ending.status = Ending::Status::failed;
    ending.reason = error.what();
  }
  ending.time = simulation.time();
  progress.clear();
  const std::string trouble = outputs.end();
  if (!trouble.empty() && trouble != ending.reason) {
    ending.status = Ending::Status::failed;
    ending.reason += (ending.reason.empty() ? "" : "; ") + trouble;
  }
  return ending;
}

}  // namespace seiche::apps
