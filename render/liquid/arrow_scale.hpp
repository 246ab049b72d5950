#pragma once
#include "render/look.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// How long velocity arrows are; the same in every frame of a run.
struct ArrowScale {
  double length = 0;     ///< of 1 m/s [font heights]
  double greatest = 0;   ///< arrows of all greater speeds are as long as that of this one [m/s]
  double reference = 0;  ///< a round speed, whose arrow stands in the key [m/s]
};

/// Arrows stand this far apart [font heights].
constexpr double arrow_distance = 2.75;

/// The font height that arrows go by: the text's, or less where the view is so narrow that fewer than eight would stand
/// side by side; down to 0.6 of it [pixels].
double arrow_font(double view_width, double font);

/// An arrow is three times as long as arrows stand apart at the greatest speed of the scene's range, which few scenes
/// reach, or of look.range where that is given as numbers for the speed.
ArrowScale arrow_scale(const RunInfo& run, const Look& look);

}  // namespace seiche::render
