#pragma once
#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

#include "render/camera.hpp"
#include "render/layout.hpp"
#include "render/look.hpp"
#include "render/palette.hpp"
#include "render/particles.hpp"
#include "solver/frame.hpp"

class vtkActor;
class vtkRenderer;

namespace seiche::render {

/// Everything that any frame of a run may show: the tank with the layers of its wall, and in the lab's view where it
/// sways to.
Bounds room_of(const RunInfo& run, const Look& look, const Frame& first);

/// Paints a renderer's background, or leaves it transparent.
void set_background(vtkRenderer* renderer, const Look& look, Rgb paper);

/// A run's tank with its particles, in a renderer.
class TankView {
 public:
  TankView(vtkRenderer* renderer, const RunInfo& run, const Look& look, const Layout& layout, const Palette& colours);

  void show(const Frame& frame, Range range);

 private:
  RunInfo run_;
  bool moves_;  // in the lab's view
  std::optional<Particles> particles_;
  std::vector<vtkSmartPointer<vtkActor>> tank_;
};

}  // namespace seiche::render
