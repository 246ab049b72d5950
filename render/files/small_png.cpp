#include "render/files/small_png.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "render/files/file.hpp"
#include "render/files/read_png.hpp"

namespace seiche::render {
namespace {

constexpr int narrowest = 320;  // [pixels]; less can't be read

// Which pixels of a row of `from` one of a row of `to` covers, and how much of each.
struct Cover {
  double low, high;
  Cover(int pixel, int from, int to)
      : low(static_cast<double>(pixel) * from / to), high(static_cast<double>(pixel + 1) * from / to) {}
  int first() const { return static_cast<int>(low); }
  int last(int from) const { return std::min(from, static_cast<int>(std::ceil(high - 1e-9))); }
  double of(int pixel) const { return std::min(high, pixel + 1.0) - std::max(low, static_cast<double>(pixel)); }
};

// Colours count by their alpha.
void average(const Image& image, const Cover& across, const Cover& down, std::uint8_t* out) {
  std::array<double, 4> sum{};
  double area = 0;
  for (int y = down.first(); y < down.last(image.height); ++y)
    for (int x = across.first(); x < across.last(image.width); ++x) {
      const std::uint8_t* pixel = &image.rgba[4 * (static_cast<std::size_t>(y) * image.width + x)];
      const double part = across.of(x) * down.of(y);
      for (int c = 0; c < 3; ++c) sum[c] += part * pixel[3] * pixel[c];
      sum[3] += part * pixel[3];
      area += part;
    }
  for (int c = 0; c < 3; ++c) out[c] = sum[3] > 0 ? static_cast<std::uint8_t>(std::lround(sum[c] / sum[3])) : 0;
  out[3] = static_cast<std::uint8_t>(std::lround(sum[3] / area));
}

std::string encoded(const Image& image) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGBA;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(png), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&png, bytes.data(), &size, 0, image.rgba.data(), 0, nullptr) == 0)
    throw std::runtime_error(fmt::format("can't encode a PNG: {}", png.message));
  bytes.resize(size);
  return bytes;
}

}  // namespace

Image shrunk(const Image& image, int width) {
  Image small{
      width, std::max(1, static_cast<int>(std::lround(static_cast<double>(width) * image.height / image.width))), {}};
  small.rgba.resize(4 * static_cast<std::size_t>(small.width) * small.height);
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x)
      average(image, Cover(x, image.width, small.width), Cover(y, image.height, small.height),
              &small.rgba[4 * (static_cast<std::size_t>(y) * small.width + x)]);
  return small;
}

std::string small_png(const std::filesystem::path& file, std::size_t most) {
  std::string bytes = read_file(file);
  if (bytes.size() <= most) return bytes;
  const Image image = read_png(file);
  // Bytes grow with the pixels, or a little slower.
  double width =
      image.width * std::min(0.9, 1.1 * std::sqrt(static_cast<double>(most) / static_cast<double>(bytes.size())));
  for (;; width *= 0.85) {
    const int pixels = std::min(image.width, std::max(narrowest, static_cast<int>(width)));
    bytes = encoded(shrunk(image, pixels));
    if (bytes.size() <= most || pixels <= narrowest) return bytes;
  }
}

}  // namespace seiche::render
