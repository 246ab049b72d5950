#pragma once

#include "solver/rigid_state.hpp"

class vtkProp3D;

namespace seiche::render {

/// Sets the pose of a prop that was made in the tank's frame, `height` above the picture's plane [m].
void set_pose(vtkProp3D* prop, const RigidState& pose, double height);

}  // namespace seiche::render
