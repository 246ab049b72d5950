#include "render/picture/pose.hpp"

#include <vtkMath.h>
#include <vtkProp3D.h>

namespace seiche::render {

void set_pose(vtkProp3D* prop, const TankPose& pose, double height) {
  prop->SetOrigin(pose.pivot[0], pose.pivot[1], 0);
  prop->SetOrientation(0, 0, vtkMath::DegreesFromRadians(pose.roll));
  prop->SetPosition(pose.displacement[0], pose.displacement[1], pose.displacement[2] + height);
}

}  // namespace seiche::render
