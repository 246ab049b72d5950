#pragma once
#include <png.h>

#include <filesystem>
#include <stdexcept>

#include "render/image.hpp"

namespace seiche::test {

inline render::Image read_png(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&png, file.c_str())) throw std::runtime_error(file.string() + ": " + png.message);
  png.format = PNG_FORMAT_RGBA;
  render::Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(png));
  if (!png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr))
    throw std::runtime_error(file.string() + ": " + png.message);
  return image;
}

}  // namespace seiche::test
