#pragma once
#include <vtkNew.h>

#include <optional>
#include <string>

#include "render/panels/grid_layout.hpp"
#include "render/panels/panel_frame.hpp"
#include "render/panels/variant.hpp"
#include "render/picture/overlay.hpp"
#include "render/picture/palette.hpp"
#include "render/view/tank_view.hpp"

class vtkRenderWindow;
class vtkRenderer;

namespace seiche::render {

/// One of the runs in a comparison: its tank, a label behind a piece of its curve, and once it has ended a veil with a
/// message over it.
class Panel {
 public:
  /// What its camera shows is all of `view`. `number`: of the run, which says how its curve is drawn. `finest`: least
  /// spacing of all runs [m].
  Panel(vtkRenderWindow* window, vtkRenderer* words, const Variant& variant, std::size_t number, const Look& look,
        const View& view, const GridLayout& layout, const Palette& colours, double finest);
  ~Panel();

  void show(const PanelFrame& frame, Range range, const std::string& note);

  /// Width of its label with the piece of curve, in font heights.
  static double label_width(const std::string& label);

 private:
  void place_label(const Variant& variant, std::size_t number, const Palette& colours);
  void place_message(const Variant& variant, const Palette& colours);

  PanelBoxes boxes_;
  double font_;
  vtkNew<vtkRenderer> tank_, veil_;  // the veil lies over the tank
  std::optional<TankView> view_;
  Overlay words_;
  vtkTextActor* note_ = nullptr;  // owned by words_
};

}  // namespace seiche::render
