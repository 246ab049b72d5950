#pragma once
#include <cstdint>
#include <vector>

#include "solver/frame.hpp"

namespace seiche::apps::validate {

/// Counts how many fluid particles join or leave the free surface between the frames of a run.
class SurfaceFlags {
 public:
  /// The next frame.
  void see(const Frame& frame);

  /// Flicker of the surface's flag: of the particles that bear it in either of two successive frames, the share that
  /// bears it in one of them alone. Mean over the pairs of frames whose middle lies in [from, to] [s], each pair with
  /// the weight of its particles: sum |A xor B| / sum |A or B|. Particles that aren't in both frames don't count. 0 is
  /// a surface of the same particles, 1 one of ever new ones; NaN where there is none.
  double changing(double from, double to) const;

 private:
  struct Flag {
    std::uint32_t id;
    bool up;
  };
  struct Pair {
    double middle;         // of their times [s]
    long changed, either;  // particles
  };
  double time_ = 0;
  std::vector<Flag> flags_;  // of the last frame's fluid, by id
  std::vector<Pair> pairs_;
};

}  // namespace seiche::apps::validate
