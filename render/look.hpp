#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solver/choice.hpp"
#include "solver/quantity.hpp"

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

enum class ColourMapName { viridis, cividis, cool_warm, turbo };
enum class Background { white, black, transparent };
/// How particles are drawn.
enum class Style { disc, dot, smooth };
/// What stands still in the picture.
enum class ReferenceFrame { tank, lab };

/// A colour range, in the unit of the quantity.
struct Range {
  double low = 0, high = 1;
};

/// Where the colour range comes from: the scene, known before the first step; each frame; the whole run, known after
/// it.
enum class RangeSource { scene, frame, run, given };

struct RangeChoice {
  RangeSource source = RangeSource::scene;
  Range given;  ///< of source `given`
};

/// Least and greatest width and height of a picture [pixels].
constexpr int least_size = 64, greatest_size = 8192;

/// Sensors, without their units, whose curves are drawn; none where the list is empty. No list: chosen automatically.
using CurveChoice = std::optional<std::vector<std::string>>;

/// How a picture looks. Every member is a scene key of [look] or [output].
struct Look {
  int width = 1280, height = 720;          ///< [pixels]
  Quantity quantity = Quantity::pressure;  ///< that particles are coloured by
  ColourMapName colour_map = ColourMapName::viridis;
  Background background = Background::white;
  Style style = Style::disc;
  ReferenceFrame view = ReferenceFrame::tank;
  RangeChoice range;
  CurveChoice curves;                 ///< below the picture
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

  bool draws_curves() const { return !curves || !curves->empty(); }
};

}  // namespace seiche::render

namespace seiche {

template <>
struct ChoiceTable<render::ColourMapName> {
  using Name = render::ColourMapName;
  static constexpr std::array rows{Choice{Name::viridis, "viridis", "from dark to light"},
                                   Choice{Name::cividis, "cividis", "the same to the colour-blind"},
                                   Choice{Name::cool_warm, "cool-warm", "diverging from a pale middle"},
                                   Choice{Name::turbo, "turbo", "a rainbow"}};
};
template <>
struct ChoiceTable<render::Background> {
  using Background = render::Background;
  static constexpr std::array rows{Choice{Background::white, "white", "for paper"},
                                   Choice{Background::black, "black", "for screens"},
                                   Choice{Background::transparent, "transparent", "to lay over something else"}};
};
template <>
struct ChoiceTable<render::Style> {
  using Style = render::Style;
  static constexpr std::array rows{
      Choice{Style::disc, "disc", "particles as edged discs that fill the spacing"},
      Choice{Style::dot, "dot", "particles as small plain discs"},
      Choice{Style::smooth, "smooth", "a mean of particles as one coloured area, 2-D only"}};
};
template <>
struct ChoiceTable<render::ReferenceFrame> {
  using ReferenceFrame = render::ReferenceFrame;
  static constexpr std::array rows{Choice{ReferenceFrame::tank, "tank", "the tank stands still"},
                                   Choice{ReferenceFrame::lab, "lab", "the tank moves"}};
};

}  // namespace seiche
