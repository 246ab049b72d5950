#pragma once
#include "render/look.hpp"

namespace seiche::render {

/// Throws std::invalid_argument for a width or height beyond least_size and greatest_size.
void check_picture_size(int width, int height);

/// Throws std::invalid_argument with the first thing in `look` that can't be drawn.
void check_look(const Look& look);

/// Throws std::invalid_argument with the first thing in `look` that a run of this dimension can't show.
void check_dimension(const Look& look, int dimension);

}  // namespace seiche::render
