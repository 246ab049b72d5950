#pragma once
#include <string>
#include <vector>

#include "render/movie_format.hpp"

namespace seiche::render {

/// Arguments that make ffmpeg encode in this format.
std::vector<std::string> encoder_options(const MovieRow& format);

/// Throws std::invalid_argument for a size that the format can't have.
void check_size(const MovieRow& format, int width, int height);

}  // namespace seiche::render
