#pragma once
#include <memory>
#include <vector>

#include "render/liquid/arrow_scale.hpp"
#include "render/picture/colour_map.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

class vtkRenderer;

namespace seiche::render {

/// Of a frame's fluid particles those that bear arrows: in each square of a grid that stands in the tank, its side
/// `apart` [m], the one nearest to its middle, unless all are in its corners.
std::vector<std::size_t> arrow_bearers(const Frame& frame, double apart);

/// Velocities relative to the tank, as arrows over a 2-D picture.
class Arrows {
 public:
  /// `scale`: pixels for each metre; `font`: height of the text [pixels].
  Arrows(vtkRenderer* renderer, const RunInfo& run, const ArrowScale& lengths, double scale, double font);
  ~Arrows();

  void show(const Frame& frame, const RigidState& pose);

  static constexpr Rgb foreground{24, 24, 28}, halo{255, 255, 255};

 private:
  struct Shapes;
  ArrowScale lengths_;
  double font_, apart_, layer_;  // [m]
  std::unique_ptr<Shapes> halos_, shafts_;
};

}  // namespace seiche::render
