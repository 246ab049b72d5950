#pragma once
#include <memory>
#include <vector>

#include "render/curves/sensor_curve.hpp"
#include "render/image.hpp"
#include "render/look.hpp"
#include "render/panels/panel_frame.hpp"
#include "render/panels/variant.hpp"

namespace seiche::render {

/// Draws several runs in panels: one scale, one colour range, one clock, one scalar bar, and below them the curves of
/// all.
class Comparison {
 public:
  /// 1 to 9 variants of one dimension. Throws std::invalid_argument.
  Comparison(std::vector<Variant> variants, const Look& look);
  ~Comparison();

  /// Takes over all readings of a variant, before anything is drawn.
  void record(std::size_t variant, const Readings& readings);

  /// One panel frame for each variant, the first ones those that settle the camera. Throws NoGl, and
  /// std::invalid_argument where the picture is too small.
  Image draw(double time, const std::vector<PanelFrame>& frames, Range range);

 private:
  struct Pipeline;
  std::vector<Variant> variants_;
  Look look_;
  std::vector<SensorCurve> curves_;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace seiche::render
