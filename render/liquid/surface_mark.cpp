#include "render/liquid/surface_mark.hpp"

#include "render/picture/quantity.hpp"

namespace seiche::render {

SurfaceMark surface_mark(const Look& look) {
  if (look.show_surface_line) return SurfaceMark::line;
  if (!look.show_surface || look.quantity == Quantity::free_surface) return SurfaceMark::none;
  return look.style == Style::smooth ? SurfaceMark::line : SurfaceMark::rings;
}

}  // namespace seiche::render
