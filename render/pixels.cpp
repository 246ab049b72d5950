#include "render/pixels.hpp"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <stdexcept>

namespace seiche::render {

Image read_pixels(vtkRenderWindow* window, int sharpness) {
  const int* size = window->GetSize();
  const int wide = size[0], high = size[1];
  vtkNew<vtkUnsignedCharArray> raw;
  if (window->GetRGBACharPixelData(0, 0, wide - 1, high - 1, 0, raw) != VTK_OK)
    throw std::runtime_error("the picture can't be read back from OpenGL");

  Image image{wide / sharpness, high / sharpness, {}};
  image.rgba.resize(static_cast<std::size_t>(image.width) * image.height * 4);
  const unsigned parts = static_cast<unsigned>(sharpness * sharpness);
  std::uint8_t* out = image.rgba.data();
  for (int y = 0; y < image.height; ++y) {
    // GL's rows go up, the picture's down.
    const std::uint8_t* row = raw->GetPointer(0) + 4L * wide * (high - (y + 1) * sharpness);
    for (int x = 0; x < image.width; ++x, out += 4) {
      unsigned sum[4] = {};
      for (int dy = 0; dy < sharpness; ++dy)
        for (int dx = 0; dx < sharpness; ++dx) {
          const std::uint8_t* pixel = row + 4L * (dy * wide + x * sharpness + dx);
          for (int c = 0; c < 4; ++c) sum[c] += pixel[c];
        }
      // GL blended over nothing: its colours are multiplied by their alpha, the picture's aren't.
      const unsigned alpha = sum[3];
      for (int c = 0; c < 3; ++c)
        out[c] = alpha == 0 ? 0 : static_cast<std::uint8_t>(std::min(255u, (255 * sum[c] + alpha / 2) / alpha));
      out[3] = static_cast<std::uint8_t>((alpha + parts / 2) / parts);
    }
  }
  return image;
}

}  // namespace seiche::render
