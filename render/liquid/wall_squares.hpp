#pragma once
#include <memory>

#include "render/picture/palette.hpp"
#include "solver/frame.hpp"
#include "solver/rigid_state.hpp"
#include "solver/run_info.hpp"

class vtkRenderer;

namespace seiche::render {

/// The wall particles and dummies of a 2-D tank as squares of a spacing that lie along its wall and leave no gaps. What
/// stands for the solid of a thin wall where there is liquid is left out.
class WallSquares {
 public:
  /// @param layer height between wall particles and dummies in the picture [m]
  WallSquares(vtkRenderer* renderer, const RunInfo& run, double layer, Rgb wall, Rgb dummy);
  ~WallSquares();

  /// Takes over the walls of the first frame: they never move in the tank.
  void show(const Frame& frame, const RigidState& pose);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace seiche::render
