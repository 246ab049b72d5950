#pragma once
#include "render/picture/boxes.hpp"

namespace seiche::render {

/// Height of the text in a picture of the size that `needs` has [pixels].
double font_height(const Needs& needs);

/// Curves go below all else. Of the room above them: tries the scalar bar beside the tank and below it, and takes what
/// shows the tank larger.
Layout lay_out(const Needs& needs);

}  // namespace seiche::render
