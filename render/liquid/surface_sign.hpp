#pragma once
#include "render/look.hpp"

namespace seiche::render {

/// How a picture shows where the free surface is.
enum class SurfaceSign { none, rings, line };

/// One sign alone: a line takes the place of rings round particles. What the colours tell needs no rings.
SurfaceSign surface_sign(const Look& look);

}  // namespace seiche::render
