#include "apps/replay/replay_frames.hpp"

#include <limits>

#include "render/files.hpp"

namespace seiche::apps {

FramePtr ReplayFrames::next(const std::stop_token& stop) {
  const auto stored = list_.next(stop);
  if (!stored) return {};
  auto frame = std::make_shared<Frame>(render::read_vtu(stored->file, stored->index));
  if (scans_ != list_.scans()) readings_ = stored_readings(run_);
  scans_ = list_.scans();
  frame->readings = readings_until(all_at_once_ ? std::numeric_limits<double>::infinity() : frame->time);
  return frame;
}

Readings ReplayFrames::readings_until(double time) {
  constexpr double rounding = 1e-6;  // of the times in probes.csv [s]
  const std::size_t columns = run_.info.sensors.size();
  Readings some;
  for (; handed_ < readings_.time.size() && readings_.time[handed_] <= time + rounding; ++handed_) {
    some.time.push_back(readings_.time[handed_]);
    const auto row = readings_.values.begin() + static_cast<std::ptrdiff_t>(handed_ * columns);
    some.values.insert(some.values.end(), row, row + static_cast<std::ptrdiff_t>(columns));
  }
  return some;
}

}  // namespace seiche::apps
