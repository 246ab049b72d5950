#pragma once
#include <optional>
#include <vector>

#include "render/liquid/arrows.hpp"
#include "render/liquid/particles.hpp"
#include "render/liquid/smooth_liquid.hpp"
#include "render/liquid/surface_line.hpp"
#include "render/look.hpp"
#include "render/picture/boxes.hpp"
#include "render/picture/camera.hpp"
#include "render/picture/palette.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

class vtkActor;
class vtkRenderer;
template <class T>
class vtkSmartPointer;

namespace seiche::render {

/// Everything that any frame of a run may show: the tank with the layers of its wall, and in the lab's view where it
/// sways to.
Bounds visible_bounds(const RunInfo& run, const Look& look, const Frame& first);

/// Paints a renderer's background, or leaves it transparent.
void set_background(vtkRenderer* renderer, const Look& look, Rgb paper);

/// A run's tank with its liquid, in a renderer.
class TankView {
 public:
  /// `finest`: least spacing of the runs in the picture [m].
  TankView(vtkRenderer* renderer, const RunInfo& run, const Look& look, const Layout& layout, const Palette& colours,
           double finest);
  ~TankView();

  void show(const Frame& frame, Range range);

 private:
  RunInfo run_;
  bool moves_;  // in the lab's view
  Quantity quantity_;
  std::optional<Particles> particles_;
  std::optional<SmoothField> field_;  // where the liquid or its surface is drawn as a whole
  std::optional<SmoothLiquid> liquid_;
  std::optional<SurfaceLine> surface_;
  std::optional<Arrows> arrows_;
  std::vector<vtkSmartPointer<vtkActor>> tank_;
};

}  // namespace seiche::render
