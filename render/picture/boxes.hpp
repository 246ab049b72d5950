#pragma once
#include <vector>

namespace seiche::render {

/// A box in pixels of the picture, from its bottom left corner.
struct Box {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double top() const { return y + height; }
};

/// Room between the picture's edge and what is in it, in font heights.
constexpr double layout_pad = 1.4;

/// What a curve under the picture has to find room for.
struct CurveNeeds {
  double title = 0, key = 0;  ///< above it
  double labels = 0;          ///< of the values, left of it
  double last_label = 0;      ///< of the times; half of it sticks out on the right
};

/// Where a curve goes.
struct CurveBoxes {
  Box plot;           ///< between its axes
  Box title, key;     ///< above it
  Box values, times;  ///< the axes' labels
};

/// What has to find its place. Widths of texts are in font heights; 0 leaves the item out.
struct Needs {
  int width = 0, height = 0;               ///< of the picture [pixels]
  double font = 1;                         ///< of the text, as part of what suits a picture of one run
  double plot = 0.16;                      ///< height of the curves' plots, as part of the picture's
  double view_width = 0, view_height = 0;  ///< of what the camera must show [m]
  double gaps_across = 0, gaps_up = 0;     ///< room within the view that isn't the camera's [font heights]
  double caption = 0, clock = 0, key = 0;
  double ruler = 0, ruler_label = 0;  ///< the ruler's length as the camera sees it [m]
  double bar_labels = 0, bar_title = 0;
  std::vector<CurveNeeds> curves{};
};

/// Where everything goes. The rows lie close around the tank, so that the picture reads as one figure.
struct Layout {
  double font = 0;   ///< height of the text [pixels]
  double line = 0;   ///< width of a thin line [pixels]
  double scale = 0;  ///< [pixels/m]
  Box view;          ///< what the camera must show
  Box caption, clock, ruler, key;
  Box bar;  ///< the colours alone, without the triangles at the ends
  bool bar_upright = true;
  std::vector<CurveBoxes> curves;  ///< none where they would take nearly half of the tank's size
};

}  // namespace seiche::render
