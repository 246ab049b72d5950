#pragma once
#include "render/picture/axis.hpp"
#include "render/picture/polyline.hpp"
#include "render/picture/quantity.hpp"
#include "render/picture/range.hpp"

// What colours show and how far they reach, axes and lines for charts drawn elsewhere.
