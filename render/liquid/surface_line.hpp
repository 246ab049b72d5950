#pragma once
#include <memory>

#include "render/liquid/smooth_field.hpp"

class vtkRenderer;

namespace seiche::render {

/// The free surface of a 2-D picture as a line: where the volume fraction is a half.
class SurfaceLine {
 public:
  /// `font`: height of the text [m].
  SurfaceLine(vtkRenderer* renderer, const RunInfo& run, double font);
  ~SurfaceLine();

  void show(const SmoothField& field, const RigidState& pose);

  static constexpr double width = 0.16;  ///< of the line [font heights]

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace seiche::render
