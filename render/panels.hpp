#pragma once
#include "render/panels/compared_curves.hpp"
#include "render/panels/comparison.hpp"
#include "render/panels/deviation.hpp"
#include "render/panels/variant.hpp"

// Several runs in one picture, and how far one is off another.
