#include "render/view/mark_shapes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace seiche::render {
namespace {

using Eigen::Vector3d;

constexpr double arc_radius = 0.2, arc_centre = 0.65;  // of an arrow's length
constexpr double arc_from = -0.6, arc_to = 1.1;        // [pi]
constexpr int arc_parts = 48;

Vector3d vector_of(const Double3& a) { return Vector3d(a.data()); }

/// The way of an arrow or an arc from its tail to its tip [m].
std::vector<Vector3d> way_of(const MotionMark& mark, const Vector3d& origin, double length) {
  const Vector3d axis = vector_of(mark.axis);
  if (!mark.rotation) return {origin, origin + length * axis};
  std::vector<Vector3d> way;
  const Vector3d across = axis.unitOrthogonal(), beside = axis.cross(across);
  // Seen from its tip an axis is a point: its arc goes round the origin.
  const Vector3d centre = origin + (std::abs(axis[2]) == 1 ? 0 : arc_centre) * length * axis;
  for (int k = 0; k <= arc_parts; ++k) {
    const double angle = std::numbers::pi * (arc_from + (arc_to - arc_from) * k / arc_parts);
    way.push_back(centre + arc_radius * length * (std::cos(angle) * across + std::sin(angle) * beside));
  }
  return way;
}

/// A head at the end of a line, its tip a little beyond.
void draw_head(Overlay& overlay, const Point& before, const Point& end, double size, Rgb colour) {
  const double length = std::hypot(end[0] - before[0], end[1] - before[1]);
  if (length == 0) return;
  const double x = (end[0] - before[0]) / length, y = (end[1] - before[1]) / length, half = 0.4 * size;
  overlay.polygon({{end[0] + 0.5 * size * x, end[1] + 0.5 * size * y},
                   {end[0] - 0.5 * size * x - half * y, end[1] - 0.5 * size * y + half * x},
                   {end[0] - 0.5 * size * x + half * y, end[1] - 0.5 * size * y - half * x}},
                  colour);
}

}  // namespace

double mark_length(const Bounds& tank) {
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, tank.high[axis] - tank.low[axis]);
  return 0.35 * longest;
}

Bounds with_marks(Bounds bounds, const MotionMarks& marks, double length) {
  for (const MotionMark& mark : marks.marks)
    for (const Vector3d& point : way_of(mark, vector_of(marks.origin), length))
      for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        bounds.low[a] = std::min(bounds.low[a], point[axis]);
        bounds.high[a] = std::max(bounds.high[a], point[axis]);
      }
  return bounds;
}

void draw_marks(Overlay& overlay, const MotionMarks& marks, double length, const View& view, const Layout& layout,
                double width, const Palette& colours) {
  const double font = layout.font, line = std::max(2.0, 0.14 * font);
  for (const MotionMark& mark : marks.marks) {
    Line way;
    for (const Vector3d& point : way_of(mark, vector_of(marks.origin), length))
      way.push_back(view.pixel({point[0], point[1], point[2]}, layout));
    const Rgb colour = line_colours[mark.rotation ? 1 : 0];
    overlay.line(way, line + 0.2 * font, colours.background);
    overlay.line(way, line, colour);
    const Point& before = way[way.size() - 2];
    const Point& end = way.back();
    draw_head(overlay, before, end, 0.8 * font, colour);
    // The name stands beyond the tip, within the picture.
    const double far = std::max(1e-9, std::hypot(end[0] - before[0], end[1] - before[1]));
    const double x = (end[0] - before[0]) / far, y = (end[1] - before[1]) / far;
    const double half = 0.5 * text_width(mark.name) * font;
    const double middle = std::clamp(end[0] + x * (half + 0.9 * font), half + 0.3 * font, width - half - 0.3 * font);
    const double height = end[1] + 1.2 * font * y;
    overlay.box({middle - half - 0.2 * font, height - 0.65 * font, 2 * half + 0.4 * font, 1.3 * font},
                colours.background);
    overlay.text(mark.name, middle, height, font, Align::centre, colour);
  }
}

}  // namespace seiche::render
