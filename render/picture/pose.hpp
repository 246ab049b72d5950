#pragma once

#include "solver/frame.hpp"

class vtkProp3D;

namespace seiche::render {

/// Stands what was made in the tank's frame where the tank is, and `height` above the picture's plane [m].
void set_pose(vtkProp3D* prop, const TankPose& pose, double height);

}  // namespace seiche::render
