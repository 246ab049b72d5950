#pragma once
#include <string>
#include <vector>

#include "render/look.hpp"
#include "solver/column.hpp"

namespace seiche::render {

/// No more curves than this find room under a picture.
constexpr std::size_t most_curves = 3;

/// As a scene writes it: "auto", "none" or names, as in "eta_left, p_left_bottom". Throws std::invalid_argument when a
/// name is empty, or they are too many.
CurveChoice parse_curves(const std::string& text);

/// The inverse of parse_curves.
std::string text_of(const CurveChoice& curves);

/// What a curve is called: "pressure, left bottom [Pa]".
std::string curve_title(const Column& column);

/// A unit as it is written by hand: "m\u00b2/s" of "m^2/s".
std::string raised_powers(std::string unit);

/// Which of the run's sensor columns are drawn. Automatically: those that have a reference, then the first elevation,
/// the first pressure and the tank's motion. Throws std::invalid_argument for a name that no column has.
std::vector<std::size_t> chosen_columns(const Look& look, const std::vector<Column>& sensors);

}  // namespace seiche::render
