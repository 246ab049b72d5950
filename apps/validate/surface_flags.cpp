#include "apps/validate/surface_flags.hpp"

#include <limits>

namespace seiche::apps::validate {

void SurfaceFlags::see(const Frame& frame) {
  std::vector<Flag> now;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) now.push_back({frame.id[i], frame.free_surface[i] != 0});

  Pair pair{(time_ + frame.time) / 2, 0, 0};
  for (auto before = flags_.begin(), after = now.begin(); before != flags_.end() && after != now.end();) {
    if (before->id == after->id) {
      pair.changed += before->up != after->up;
      pair.either += before->up || after->up;
      ++before, ++after;
    } else if (before->id < after->id) {
      ++before;
    } else {
      ++after;
    }
  }
  if (!flags_.empty()) pairs_.push_back(pair);
  time_ = frame.time;
  flags_ = std::move(now);
}

double SurfaceFlags::changing(double from, double to) const {
  long changed = 0, either = 0;
  for (const Pair& pair : pairs_) {
    if (pair.middle < from || pair.middle > to) continue;
    changed += pair.changed;
    either += pair.either;
  }
  return either > 0 ? static_cast<double>(changed) / static_cast<double>(either)
                    : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace seiche::apps::validate
