#pragma once
#include "render/motion_marks.hpp"
#include "render/picture/boxes.hpp"
#include "render/picture/camera.hpp"
#include "render/picture/overlay.hpp"
#include "render/picture/palette.hpp"

namespace seiche::render {

/// Length of the arrows of degrees of freedom in a tank of those bounds [m].
double mark_length(const Bounds& tank);

/// The bounds with all arrows and arcs in them.
Bounds with_marks(Bounds bounds, const MotionMarks& marks, double length);

/// Draws arrows and arcs with their names over the picture.
/// @param width of the picture [pixels]
void draw_marks(Overlay& overlay, const MotionMarks& marks, double length, const View& view, const Layout& layout,
                double width, const Palette& colours);

}  // namespace seiche::render
