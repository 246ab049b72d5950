#pragma once
#include <memory>

#include "render/liquid/smooth_field.hpp"
#include "render/look.hpp"
#include "render/picture/colour_map.hpp"

class vtkRenderer;

namespace seiche::render {

/// The liquid of a 2-D picture as one coloured area: where the volume fraction is above a half.
class SmoothLiquid {
 public:
  SmoothLiquid(vtkRenderer* renderer, const RunInfo& run, const SmoothField& field, const ColourMap& map);
  ~SmoothLiquid();

  void show(const SmoothField& field, Range range, const RigidState& pose);

 private:
  struct Parts;
  ColourMap map_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace seiche::render
