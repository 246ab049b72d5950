#pragma once
#include <cstddef>
#include <filesystem>
#include <string>

#include "render/image.hpp"

namespace seiche::render {

/// The picture at another width, smaller than its own; its height follows. Each pixel is the mean of what it covers.
Image shrunk(const Image& image, int width);

/// The bytes of a PNG file, as they are where they are `most` at most, else of a smaller picture of it, no narrower
/// than 320 pixels, that is. Throws std::runtime_error where the file can't be read.
std::string small_png(const std::filesystem::path& file, std::size_t most);

}  // namespace seiche::render
