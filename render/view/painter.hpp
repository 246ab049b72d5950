#pragma once
#include <memory>

#include "render/curves/sensor_curve.hpp"
#include "render/image.hpp"
#include "render/look.hpp"
#include "render/motion_marks.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// Draws frames of one run with one look. The first frame's walls settle the camera, which then never moves.
class Painter {
 public:
  /// Throws NoGl, and std::invalid_argument when a member of `look` is wrong.
  Painter(const RunInfo& run, const Look& look);
  ~Painter();

  /// Shows degrees of freedom over the tank. Call it before the first frame.
  void mark(MotionMarks marks) { marks_ = std::move(marks); }

  /// Takes over readings for the curves under the picture: a frame shows those up to its time, on axes that hold all.
  void record(const Readings& readings);

  Image draw(const Frame& frame, Range range);

 private:
  struct Pipeline;
  RunInfo run_;
  Look look_;
  MotionMarks marks_;
  std::vector<SensorCurve> curves_;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace seiche::render
