#include "solver/modes/element_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/tank/edge.hpp"

namespace seiche::solver::modes {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Angle of the liquid at a corner, from 0 to 2 pi.
double angle_at(const Vec<2>& before, const Vec<2>& here, const Vec<2>& after) {
  const Vec<2> in = here - before, out = after - here;
  const double left = std::atan2(cross(in, out), in.dot(out));
  return std::numbers::pi - left;
}

}  // namespace

ElementSize::ElementSize(const Outline& outline, int along, double longest) {
  double length = 0;
  for (std::size_t k = 0; k < outline.outer.size(); ++k)
    if (outline.outer[k].surface) {
      length += (outline.outer[(k + 1) % outline.outer.size()].at - outline.outer[k].at).norm();
      level_ = outline.outer[k].at[1];
    }
  at_surface_ = std::min(length / along, longest / outline.unit);
  growth_ = 8.0 / along;
  add(outline.outer);
  for (const Loop& hole : outline.holes) add(hole);
}

void ElementSize::add(const Loop& loop) {
  const std::size_t count = loop.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Vec<2>&before = loop[(k + count - 1) % count].at, &here = loop[k].at, &after = loop[(k + 1) % count].at;
    const double angle = angle_at(before, here, after);
    double size = std::min((here - before).norm(), (after - here).norm());
    // The error that a corner leaves goes with its triangles' size to the power 2 pi/angle.
    if (angle > 100 * degree && std::abs(angle - 180 * degree) > 10 * degree)
      size = std::min(size, at_surface_ * std::pow(1e-4, angle / (360 * degree)));
    if (size < at_surface_ + growth_ * (level_ - here[1])) sources_.push_back({here, size});
  }
}

double ElementSize::operator()(const Vec<2>& at) const {
  double size = at_surface_ + growth_ * (level_ - at[1]);
  for (const Source& source : sources_) {
    const double reach = (size - source.size) / growth_, squared = (at - source.at).squaredNorm();
    if (reach > 0 && squared < reach * reach) size = source.size + growth_ * std::sqrt(squared);
  }
  return size;
}

}  // namespace seiche::solver::modes
