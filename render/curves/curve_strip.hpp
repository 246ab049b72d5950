#pragma once
#include <memory>
#include <vector>

#include "render/curves/sensor_curve.hpp"
#include "render/picture/boxes.hpp"
#include "render/picture/palette.hpp"

class vtkRenderer;

namespace seiche::render {

class CurvePanel;

/// The curves under the picture, side by side over one span of time.
class CurveStrip {
 public:
  /// `curves` outlive it.
  explicit CurveStrip(const std::vector<SensorCurve>& curves);
  ~CurveStrip();

  /// Fills in what they take up.
  void reserve(Needs& needs) const;

  void place(vtkRenderer* renderer, const Layout& layout, const Palette& colours);

  /// Draws the readings up to a time [s], with a mark there.
  void show(double time);

 private:
  const std::vector<SensorCurve>& curves_;
  std::vector<std::unique_ptr<CurvePanel>> panels_;  // as many as the layout has room for
};

}  // namespace seiche::render
