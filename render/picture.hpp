#pragma once
#include "render/picture/polyline.hpp"
#include "render/picture/quantity.hpp"
#include "render/picture/range.hpp"
#include "render/picture/ticks.hpp"

// What colours show and how far they reach, round numbers and lines for charts drawn elsewhere.
