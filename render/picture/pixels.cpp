#include "render/picture/pixels.hpp"

#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace seiche::render {
namespace {

constexpr unsigned parts = sharpness * sharpness;

// GL blended over nothing: its colours are multiplied by their alpha, the picture's aren't.
void divide_by_alpha(const std::array<unsigned, 4>& sum, std::uint8_t* out) {
  const unsigned alpha = sum[3];
  for (std::size_t c = 0; c < 3; ++c)
    out[c] = alpha == 0 ? 0 : static_cast<std::uint8_t>(std::min(255u, (255 * sum[c] + alpha / 2) / alpha));
  out[3] = static_cast<std::uint8_t>((alpha + parts / 2) / parts);
}

void average_row(const std::uint8_t* rows, int wide, int count, std::uint8_t* out) {
  for (int x = 0; x < count; ++x, out += 4) {
    std::array<unsigned, 4> sum{};
    for (int dy = 0; dy < sharpness; ++dy)
      for (int dx = 0; dx < sharpness; ++dx)
        for (std::size_t c = 0; c < 4; ++c)
          sum[c] += rows[4L * (dy * wide + x * sharpness + dx) + static_cast<long>(c)];
    if (sum[3] == 255 * parts)
      for (std::size_t c = 0; c < 4; ++c) out[c] = static_cast<std::uint8_t>((sum[c] + parts / 2) / parts);
    else
      divide_by_alpha(sum, out);
  }
}

}  // namespace

PixelReader::PixelReader() : raw_(vtkUnsignedCharArray::New()) {}

void PixelReader::Release::operator()(vtkUnsignedCharArray* array) const { array->Delete(); }

Image PixelReader::read(vtkRenderWindow* window) {
  const int* size = window->GetSize();
  const int wide = size[0], high = size[1];
  if (window->GetRGBACharPixelData(0, 0, wide - 1, high - 1, 0, raw_.get()) != VTK_OK)
    throw std::runtime_error("the picture can't be read back from OpenGL");

  Image image{wide / sharpness, high / sharpness, {}};
  image.rgba.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  // GL's rows go up, the picture's down.
  for (int y = 0; y < image.height; ++y)
    average_row(raw_->GetPointer(4L * wide * (high - (y + 1) * sharpness)), wide, image.width,
                image.rgba.data() + 4L * image.width * y);
  return image;
}

}  // namespace seiche::render
