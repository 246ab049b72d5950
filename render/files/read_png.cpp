#include "render/files/read_png.hpp"

#include <fmt/format.h>
#include <png.h>

#include <stdexcept>

namespace seiche::render {

Image read_png(const std::filesystem::path& file) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto check = [&](int fine) {
    if (fine && png.warning_or_error == 0) return;
    const std::string why = png.message;
    png_image_free(&png);
    throw std::runtime_error(fmt::format("{} can't be read: {}", file.string(), why));
  };
  check(png_image_begin_read_from_file(&png, file.c_str()));
  png.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.rgba.resize(PNG_IMAGE_SIZE(png));
  check(png_image_finish_read(&png, nullptr, image.rgba.data(), 0, nullptr));
  return image;
}

}  // namespace seiche::render
