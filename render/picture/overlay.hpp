#pragma once
#include <memory>
#include <string>
#include <vector>

#include "render/picture/boxes.hpp"
#include "render/picture/colour_map.hpp"
#include "render/picture/polyline.hpp"

class vtkRenderer;
class vtkTextActor;
class vtkTextProperty;

namespace seiche::render {

enum class Align { left, centre, right };

/// Flat shapes and texts laid over a renderer, placed in pixels of the picture.
class Overlay {
 public:
  /// `opacity`: of its shapes.
  explicit Overlay(vtkRenderer* renderer, double opacity = 1);
  ~Overlay();

  /// A convex polygon.
  void polygon(const std::vector<Point>& corners, Rgb colour);
  void box(const Box& box, Rgb colour);
  /// A circle with a hole; no hole when `inner` is 0.
  void ring(double x, double y, double inner, double outer, Rgb colour);

  /// An upright cross turned by 45 degrees, each arm `reach` long.
  void cross(double x, double y, double reach, double width, Rgb colour);

  /// A line through points, its inner corners without notches.
  void line(const Line& points, double width, Rgb colour);

  /// Takes everything away again.
  void clear();

  /// A line of text, its middle at height y. The actor's text may change later.
  vtkTextActor* text(const std::string& words, double x, double y, double font, Align align, Rgb colour);

 private:
  vtkRenderer* renderer_;
  struct Shapes;
  std::unique_ptr<Shapes> shapes_;
};

/// The font of all pictures. VTK's own "Arial" is whatever the machine has in its stead.
void set_font(vtkTextProperty* style);

/// Width of a line of text in font heights.
double text_width(const std::string& words);

/// The words in lines no wider than `room` font heights, but for single words that are; a unit stays with its number.
std::vector<std::string> wrapped(const std::string& words, double room);

/// The words, cut at the end until they are no wider than `room` font heights.
std::string shortened(std::string words, double room);

}  // namespace seiche::render
