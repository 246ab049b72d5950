#include "solver/tank/box.hpp"
#include "solver/tank/shape.hpp"

namespace seiche::solver {

template <int D>
std::shared_ptr<const Shape<D>> make_shape(const Parameters& p) {
  return std::make_shared<Box<D>>(p);
}

template std::shared_ptr<const Shape<2>> make_shape(const Parameters& p);
template std::shared_ptr<const Shape<3>> make_shape(const Parameters& p);

SurfaceMesh wall_surface(const Parameters& p) {
  return p.dimension() == 3 ? make_shape<3>(p)->surface() : make_shape<2>(p)->surface();
}

void check_shape(const Parameters& p) { check_box(p); }

}  // namespace seiche::solver
