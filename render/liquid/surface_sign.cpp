#include "render/liquid/surface_sign.hpp"

#include "render/picture/quantity.hpp"

namespace seiche::render {

SurfaceSign surface_sign(const Look& look) {
  if (look.show_surface_line) return SurfaceSign::line;
  if (!look.show_surface || look.quantity == Quantity::free_surface) return SurfaceSign::none;
  return look.style == Style::smooth ? SurfaceSign::line : SurfaceSign::rings;
}

}  // namespace seiche::render
