#pragma once
#include "render/look.hpp"

namespace seiche::render {

/// How a picture shows where the free surface is.
enum class SurfaceMark { none, rings, line };

/// One sign alone: a line takes the place of rings round particles. What the colours tell needs no rings.
SurfaceMark surface_mark(const Look& look);

}  // namespace seiche::render
