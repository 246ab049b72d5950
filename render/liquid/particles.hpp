#pragma once
#include <memory>

#include "render/liquid/smooth_field.hpp"
#include "render/liquid/wall_squares.hpp"
#include "render/look.hpp"
#include "render/picture/colour_map.hpp"
#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

class vtkRenderer;

namespace seiche::render {

/// The particles of a frame in a renderer. 2-D: flat discs; 3-D: spheres, where walls are left to the tank's outline.
class Particles {
 public:
  /// `scale`: pixels for each metre; `stroke`: width of the free surface's marks [pixels]; `finest`: least spacing of
  /// the runs in one picture, whose discs all close up or none [m].
  Particles(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke, double finest);
  ~Particles();

  /// Takes over a frame's particles, of a tank that stands as `pose` says. Of the fluid only spray is shown where the
  /// liquid is a smooth area: what lies outside of it.
  void show(const Frame& frame, Range range, const RigidState& pose, const SmoothField* area = nullptr);

  /// 2-D: what lies between walls, fluid and marks along z; far more than the relief of any of them [m].
  static double layer_height(const RunInfo& run);

  static constexpr Rgb surface_colour{255, 88, 24};
  static constexpr Rgb wall_colour{128, 132, 138};
  static constexpr Rgb dummy_colour{196, 199, 203};

 private:
  struct Layer;
  void make_spheres(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke);
  void make_discs(vtkRenderer* renderer, const RunInfo& run, const Look& look, double scale, double stroke,
                  double finest);

  Rgb wall(Kind kind) const;

  Quantity quantity_;
  ColourMap map_;
  std::unique_ptr<Layer> fluid_, marked_, surface_, wall_, dummy_;  // null when not shown
  std::unique_ptr<WallSquares> squares_;                            // in place of wall_ and dummy_
};

}  // namespace seiche::render
