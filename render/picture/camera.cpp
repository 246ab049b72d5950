#include "render/picture/camera.hpp"

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

View::View(int dimension, const Bounds& bounds) {
  if (dimension == 2) {
    right_ = {1, 0, 0};
    up_ = {0, 1, 0};
    back_ = {0, 0, 1};
  } else {
    right_ = {std::sqrt(0.5), 0, -std::sqrt(0.5)};
    up_ = {-std::sqrt(1 / 6.0), std::sqrt(2 / 3.0), -std::sqrt(1 / 6.0)};
    back_ = towards_camera;
  }
  low_ = {1e300, 1e300};
  high_ = {-1e300, -1e300};
  depth_ = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Double3 at;
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = (corner >> axis & 1) ? bounds.high[axis] : bounds.low[axis];
    low_ = {std::min(low_[0], dot(at, right_)), std::min(low_[1], dot(at, up_))};
    high_ = {std::max(high_[0], dot(at, right_)), std::max(high_[1], dot(at, up_))};
    depth_ = std::max(depth_, std::abs(dot(at, back_)));
  }
}

std::array<double, 2> View::pixel(const Double3& at, const Layout& layout) const {
  const Box& view = layout.view;
  return {view.x + view.width / 2 + layout.scale * (dot(at, right_) - (low_[0] + high_[0]) / 2),
          view.y + view.height / 2 + layout.scale * (dot(at, up_) - (low_[1] + high_[1]) / 2)};
}

void View::aim(vtkRenderer* renderer, const Layout& layout, int picture_width, int picture_height) const {
  const double x =
      (low_[0] + high_[0]) / 2 + (picture_width / 2.0 - layout.view.x - layout.view.width / 2) / layout.scale;
  const double y =
      (low_[1] + high_[1]) / 2 + (picture_height / 2.0 - layout.view.y - layout.view.height / 2) / layout.scale;
  Double3 focus, position;
  const double away = 3 * (depth_ + width() + height());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    focus[axis] = x * right_[axis] + y * up_[axis];
    position[axis] = focus[axis] + away * back_[axis];
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(focus.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up_.data());
  camera->SetParallelScale(picture_height / (2 * layout.scale));
  camera->SetClippingRange(away / 3, away * 5 / 3);
}

}  // namespace seiche::render
