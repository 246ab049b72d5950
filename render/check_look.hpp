#pragma once
#include "render/look.hpp"

namespace seiche::render {

/// Throws std::invalid_argument with the first thing in `look` that can't be drawn.
void check_look(const Look& look);

/// Throws std::invalid_argument with the first thing in `look` that a run of this dimension can't show.
void check_dimension(const Look& look, int dimension);

}  // namespace seiche::render
