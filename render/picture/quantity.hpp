#pragma once
#include <string>
#include <vector>

#include "render/picture/colour_map.hpp"
#include "solver/frame.hpp"
#include "solver/quantity.hpp"

namespace seiche::render {

/// What stands above its colours, with the unit, as in "pressure [Pa]".
std::string title_of(Quantity quantity);

/// Of one particle, in the unit of the title; of a quantity with classes their number. Throws std::runtime_error where
/// the frame was stored by a version that didn't derive the quantity.
double value_of(Quantity quantity, const Frame& frame, std::size_t particle);

/// One of a few values with a name and a colour of its own, for a quantity that is not a number.
struct Class {
  const char* name;
  Rgb colour;
};

/// By their values, from 0; empty for a quantity that is a number. Colours are told apart by the colour-blind, too.
const std::vector<Class>& classes_of(Quantity quantity);

}  // namespace seiche::render
