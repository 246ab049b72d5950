#include "render/picture/pose.hpp"

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkProp3D.h>

namespace seiche::render {

void set_pose(vtkProp3D* prop, const RigidState& pose, double height) {
  const Eigen::Matrix3d rotation = pose.orientation.toRotationMatrix();
  const Eigen::Vector3d origin = pose.in_lab(Eigen::Vector3d::Zero()) + height * Eigen::Vector3d::UnitZ();
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) matrix->SetElement(i, j, rotation(i, j));
    matrix->SetElement(i, 3, origin[i]);
  }
  prop->SetUserMatrix(matrix);
}

}  // namespace seiche::render
