#pragma once
#include <array>
#include <cmath>

#include "render/picture/boxes.hpp"
#include "solver/frame.hpp"

class vtkRenderer;

namespace seiche::render {

/// A box in space [m].
struct Bounds {
  Double3 low{}, high{};
};

/// In 3-D from anywhere: equal angles with all three axes, seen from the far end of each.
inline const Double3 towards_camera{std::sqrt(1 / 3.0), std::sqrt(1 / 3.0), std::sqrt(1 / 3.0)};

/// A parallel camera: from the front in 2-D, isometric from above in 3-D.
class View {
 public:
  View(int dimension, const Bounds& bounds);

  double width() const { return high_[0] - low_[0]; }  ///< of the bounds as the camera sees them [m]
  double height() const { return high_[1] - low_[1]; }

  /// Seen length of a tank's edge of 1 m, the same for each [m].
  double foreshortening() const { return right_[0] == 1 ? 1 : std::sqrt(2 / 3.0); }

  /// Where a place in space is in the picture [pixels, from its bottom left corner].
  std::array<double, 2> pixel(const Double3& at, const Layout& layout) const;

  /// Puts the camera so that the bounds fill layout.view of a picture of the given size [pixels].
  void aim(vtkRenderer* renderer, const Layout& layout, int picture_width, int picture_height) const;

 private:
  Double3 right_, up_, back_;
  std::array<double, 2> low_, high_;
  double depth_;
};

}  // namespace seiche::render
