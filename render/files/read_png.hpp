#pragma once
#include <filesystem>

#include "render/image.hpp"

namespace seiche::render {

/// Any PNG as RGBA. Throws std::runtime_error where the file is missing, damaged or no PNG. May be called on any
/// thread.
Image read_png(const std::filesystem::path& file);

}  // namespace seiche::render
