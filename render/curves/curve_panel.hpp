#pragma once
#include <optional>

#include "render/curves/sensor_curve.hpp"
#include "render/picture/axis.hpp"
#include "render/picture/boxes.hpp"
#include "render/picture/overlay.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/polyline.hpp"

namespace seiche::render {

/// One sensor's curves over time between their axes: each run's readings up to now, references dashed for the whole
/// run, and a mark at the present time. A cross stands where a run has failed.
class CurvePanel {
 public:
  /// `curve` outlives it.
  CurvePanel(vtkRenderer* renderer, const CurveBoxes& place, double font, const SensorCurve& curve,
             const Palette& colours);

  void show(double time);

  static constexpr const char* time_title = "t [s]";

 private:
  void draw_axes();
  void draw_values();
  void draw_times();
  void draw_references();
  void draw_trace(const Trace& trace, double time);
  Point at(const Point& point) const;
  Line at(Line line) const;

  CurveBoxes boxes_;
  double font_, thin_;  // heights of the text, and of a thin line [pixels]
  const SensorCurve& curve_;
  Palette colours_;
  Overlay axes_, line_, references_, mark_;  // in the order in which they lie over each other
  Axis times_;
  std::optional<Axis> values_;
};

}  // namespace seiche::render
