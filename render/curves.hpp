#pragma once
#include "render/curves/curve_choice.hpp"

// Which sensors have a curve, and what they are called.
