#pragma once
#include <string>
#include <utility>
#include <vector>

#include "render/curves/sensor_curve.hpp"
#include "render/panels/grid_layout.hpp"
#include "render/panels/variant.hpp"

namespace seiche::render {

/// How much is said above the panels: of labels the values alone; of deviations, not from what.
struct Wording {
  bool brief_labels = false, brief_notes = false;
};

/// The values alone of a label such as "viscosity 0.001 m\u00b2/s, amplitude 20 mm": "0.001 m\u00b2/s, 20 mm".
std::string brief(const std::string& label);

/// The first curve with something to compare it with, whose deviation is told above each panel; null where there is
/// none.
const SensorCurve* measured(const std::vector<SensorCurve>& curves);

/// How far a variant is off up to a time, as in "4.1 mm RMS off VOF"; empty without a curve.
std::string note_of(const SensorCurve* curve, std::size_t variant, double time, Wording wording);

/// Where panels go, in the fullest wording of those that find room for the most labels, and then notes.
/// @param picture its view is that of one panel
std::pair<GridLayout, Wording> worded_layout(const Needs& picture, const std::vector<Variant>& variants,
                                             const SensorCurve* curve);

}  // namespace seiche::render
