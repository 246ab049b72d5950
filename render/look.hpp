#pragma once
#include <string>
#include <vector>

namespace seiche::render {

/// Values over time.
struct Series {
  std::vector<double> time;   ///< [s], ascending
  std::vector<double> value;  ///< one for each time
};

/// A series to compare a sensor's curve with, drawn over it for the whole run.
struct Reference {
  std::string of;      ///< the sensor, without its unit, as in "eta_left"
  std::string label;   ///< what the picture calls it
  std::string file;    ///< CSV that it comes from
  std::string column;  ///< of the file
  double from = 0;     ///< what comes before it is left out [s]
  Series series;
};

/// How a picture looks. Every member is a scene key of [look] or [output].
struct Look {
  int width = 1280, height = 720;      ///< [pixels]
  std::string quantity = "pressure";   ///< that particles are coloured by; quantity.hpp has their names
  std::string colour_map = "viridis";  ///< viridis | cividis | cool-warm | turbo
  std::string background = "white";    ///< white | black | transparent
  /// disc: edged discs that fill the spacing | dot: small plain ones | smooth: one coloured area, 2-D only
  std::string style = "disc";
  std::string view = "tank";          ///< tank: the tank stands still | lab: the tank moves
  std::string range = "scene";        ///< scene | frame | run | "min,max" in the unit of the quantity
  std::string curves = "auto";        ///< auto | none | sensors without their units, as in "eta_left, p_left_bottom"
  std::vector<Reference> references;  ///< one to a [[look.reference]]
  bool show_arrows = false;           ///< velocities relative to the tank, on a choice of particles; 2-D only
  bool show_walls = true;
  bool show_surface = true;        ///< mark free-surface particles; with style smooth: draw the free surface
  bool show_surface_line = false;  ///< the free surface as a line instead of marks on particles; 2-D only
  bool show_tank = true;           ///< the tank's outline
  bool show_bar = true;            ///< the scalar bar
  bool show_clock = true;
  bool show_caption = true;  ///< kernel, spacing, scene
  bool show_ruler = true;
};

/// A colour range, in the unit of the quantity.
struct Range {
  double low = 0, high = 1;
};

}  // namespace seiche::render
