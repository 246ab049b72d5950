#include "apps/run/loop.hpp"

#include <algorithm>
#include <cmath>

#include "apps/common/stopwatch.hpp"
#include "apps/run/frame_queue.hpp"

namespace seiche::apps {
namespace {

// A last interval shorter than this share of one is rounding, not a frame.
constexpr double sliver = 1e-6;

long last_frame(const RunInfo& run) { return std::lround(std::ceil(run.end / run.frame_interval - sliver)); }

bool is_finite(const Frame& frame) {
  const auto finite = [](float value) { return std::isfinite(value); };
  const auto all_finite = [&](const Float3& vector) { return std::ranges::all_of(vector, finite); };
  return std::ranges::all_of(frame.position, all_finite) && std::ranges::all_of(frame.velocity, all_finite) &&
         std::ranges::all_of(frame.pressure, finite) && std::ranges::all_of(frame.number_density, finite);
}

// The state that a run broke off in shows why, if it can be shown and isn't the last frame's already.
void push_broken(Simulation& simulation, FrameQueue& queue, long index, double last_time) {
  if (simulation.time() <= last_time) return;
  const FramePtr frame = simulation.frame(index);
  if (is_finite(*frame)) queue.push(frame);
}

// The loop itself; throws what the simulation throws, and breaks off once an output has failed.
Ending::Status step_through(Simulation& simulation, FrameQueue& queue, const RunInfo& run, Progress& progress,
                            const std::function<bool()>& stop) {
  const Stopwatch watch;
  const long last = last_frame(run);
  for (long k = 0; k <= last; ++k) {
    const double target = k == last ? run.end : static_cast<double>(k) * run.frame_interval;
    while (simulation.time() < target) {
      try {
        simulation.step(target);
      } catch (const RunFailure&) {
        push_broken(simulation, queue, k, static_cast<double>(k - 1) * run.frame_interval);
        throw;
      }
      if (queue.failed()) return Ending::Status::failed;
      progress.show({simulation.time(), run.end, k, last, simulation.statistics().steps, watch.seconds(), stop()});
    }
    queue.push(simulation.frame(k));
    if (k < last && stop()) return Ending::Status::interrupted;
  }
  return Ending::Status::finished;
}

// Waits until the outputs have what is still in the queue, and says so if it lasts. Returns how long [s].
double drain(FrameQueue& queue, Progress& progress) {
  const Stopwatch watch;
  queue.close();
  while (!queue.ended_within(Progress::bar_interval)) progress.show_rest(queue.waiting(), watch.seconds());
  return watch.seconds();
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

std::string Ending::reason() const {
  std::string all = failure ? sentence(*failure) : "";
  add_error(all, error);
  return all;
}

Ending run_loop(Simulation& simulation, Outputs& outputs, const RunInfo& run, Progress& progress,
                const std::function<bool()>& stop) {
  Ending ending;
  FrameQueue queue(outputs, run);
  try {
    ending.status = step_through(simulation, queue, run, progress, stop);
  } catch (const RunFailure& error) {
    ending.status = Ending::Status::failed;
    ending.failure = error.failure;
  } catch (const std::exception& error) {
    ending.status = Ending::Status::failed;
    ending.error = error.what();
  }
  ending.time = simulation.time();
  const double rest = drain(queue, progress);
  progress.clear();
  ending.waited = queue.waited() + rest;
  ending.frames = queue.taken();
  if (!queue.error().empty()) ending.status = Ending::Status::failed;
  add_error(ending.error, queue.error());
  return ending;
}

}  // namespace seiche::apps
