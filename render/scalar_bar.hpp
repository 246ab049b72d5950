#pragma once
#include <optional>
#include <string>

#include "render/overlay.hpp"
#include "render/range.hpp"

namespace seiche::render {

/// The colours of a range under the title "pressure [Pa]", with round ticks, and at the ends triangles that stand for
/// all values beyond it. How far a frame goes beyond is written beside them.
class ScalarBar {
 public:
  ScalarBar(vtkRenderer* renderer, const Layout& layout, const ColourMap& map, Rgb ink);

  /// `found`: least and greatest value of the frame.
  void show(Range range, Range found);

  static constexpr const char* title = "pressure [Pa]";
  /// Width that the labels of a range may take, in font heights.
  static double label_width(Range range);

 private:
  void draw_colours();
  void draw_ticks();
  /// The bar's point at `along` (0 at its lower end, 1 at its upper) and `across` pixels from its side.
  std::array<double, 2> at(double along, double across) const;

  Overlay overlay_;
  Layout layout_;
  ColourMap map_;
  Rgb ink_;
  std::optional<Range> range_;
  vtkTextActor *below_ = nullptr, *above_ = nullptr;  // owned by overlay_
};

}  // namespace seiche::render
