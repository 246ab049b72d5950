#pragma once
#include "render/image.hpp"

class vtkRenderWindow;

namespace seiche::render {

/// The window's picture, each pixel the mean of `sharpness` x `sharpness` of the window's.
Image read_pixels(vtkRenderWindow* window, int sharpness);

}  // namespace seiche::render
