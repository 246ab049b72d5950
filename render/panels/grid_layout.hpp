#pragma once
#include <vector>

#include "render/picture/boxes.hpp"

namespace seiche::render {

/// Widths of the texts above a panel, in font heights.
struct PanelNeeds {
  double label = 0;  ///< with the piece of curve before it
  double note = 0;   ///< 0: none
};

/// Where a panel goes.
struct PanelBoxes {
  Box view;   ///< what its camera shows, its left and lower edge on whole pixels
  Box label;  ///< above it
  Box note;   ///< beside the label; without width where it has no room
};

/// A picture of several panels.
struct GridLayout {
  Layout around;  ///< its view is the grid with the panels' labels
  std::vector<PanelBoxes> panels;
};

/// Panels of one size, row by row, in as many columns as show them largest; all else goes around them as around a
/// single view.
/// @param picture its view is that of one panel
GridLayout lay_out_grid(const Needs& picture, const std::vector<PanelNeeds>& panels);

}  // namespace seiche::render
