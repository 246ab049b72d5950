#pragma once
#include <optional>
#include <string>

#include "render/picture/overlay.hpp"
#include "render/picture/quantity.hpp"

namespace seiche::render {

/// The colours of a range under the quantity's title, with round ticks, and at the ends triangles that stand for all
/// values beyond it. How far a frame goes beyond is written beside them. Classes are blocks, each with its name.
class ScalarBar {
 public:
  ScalarBar(vtkRenderer* renderer, const Layout& layout, Quantity quantity, const ColourMap& map, Rgb foreground);

  /// `found`: least and greatest value of the frame.
  void show(Range range, Range found);

  /// Width that the labels of a range may take, in font heights.
  static double label_width(Quantity quantity, Range range);

 private:
  void draw_colours();
  void draw_ticks();
  void draw_classes();
  void draw_title();
  /// The bar's point at `along` (0 at its lower end, 1 at its upper) and `across` pixels from its side.
  std::array<double, 2> at(double along, double across) const;

  Overlay overlay_;
  Layout layout_;
  Quantity quantity_;
  ColourMap map_;
  Rgb foreground_;
  std::optional<Range> range_;
  vtkTextActor *below_ = nullptr, *above_ = nullptr;  // owned by overlay_; null with classes
};

}  // namespace seiche::render
