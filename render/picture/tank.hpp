#pragma once
#include "render/picture/colour_map.hpp"
#include "solver/run_info.hpp"

class vtkActor;
template <class T>
class vtkSmartPointer;

namespace seiche::render {

/// The tank's inner outline, without a lid when it is open. `line` [m] is its width.
vtkSmartPointer<vtkActor> tank_outline(const RunInfo& run, double line, Rgb colour);

/// The floor and the two walls of a 3-D tank that are farthest from the camera.
vtkSmartPointer<vtkActor> tank_back(const RunInfo& run, Rgb colour);

}  // namespace seiche::render
