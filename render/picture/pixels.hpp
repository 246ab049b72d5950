#pragma once
#include <memory>

#include "render/image.hpp"

class vtkRenderWindow;
class vtkUnsignedCharArray;

namespace seiche::render {

/// The window has this many pixels, squared, for each pixel of the picture: that makes edges smooth.
constexpr int sharpness = 2;

/// Reads a window's pictures back, each pixel the mean of sharpness x sharpness of the window's.
class PixelReader {
 public:
  PixelReader();
  Image read(vtkRenderWindow* window);

 private:
  struct Release {
    void operator()(vtkUnsignedCharArray* array) const;
  };
  std::unique_ptr<vtkUnsignedCharArray, Release> raw_;  // kept, since at 3840 x 2160 its pages alone cost 0.3 s
};

}  // namespace seiche::render
