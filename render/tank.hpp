#pragma once
#include <vtkSmartPointer.h>

#include "render/colour_map.hpp"
#include "solver/frame.hpp"

class vtkActor;

namespace seiche::render {

/// The tank's inner outline, without a lid when it is open. `line` [m] is its width.
vtkSmartPointer<vtkActor> tank_outline(const RunInfo& run, double line, Rgb colour);

}  // namespace seiche::render
