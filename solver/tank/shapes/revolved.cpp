#include "solver/tank/shapes/revolved.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/tank/shapes/layer.hpp"
#include "solver/tank/shapes/mirrored.hpp"
#include "solver/tank/shapes/tolerance.hpp"

namespace seiche::solver {
namespace {

using std::numbers::pi;

/// Integral of x^2 dy along an edge.
double squares(const Edge& edge) {
  if (edge.bulge == 0) {
    const double a = edge.from[0], b = edge.to[0];
    return (edge.to[1] - edge.from[1]) * (a * a + a * b + b * b) / 3;
  }
  // x = c + R cos t, dy = R cos t dt.
  const Vec<2> centre = edge.centre();
  const double c = centre[0], radius = edge.radius();
  const double begin = std::atan2(edge.from[1] - centre[1], edge.from[0] - c), end = begin + edge.angle();
  const auto primitive = [&](double t) {
    const double sine = std::sin(t);
    return radius * (c * c * sine + c * radius * (t + 0.5 * std::sin(2 * t)) +
                     radius * radius * (sine - sine * sine * sine / 3));
  };
  return primitive(end) - primitive(begin);
}

}  // namespace

Revolved::Revolved(const Contour& half, std::vector<std::string> patches, int axis, const Vec<3>& origin)
    : half_(half), whole_(mirrored(half)), patches_(std::move(patches)), axis_(axis), origin_(origin), bends_(whole_) {}

Vec<3> Revolved::arm(double angle) const {
  // From y towards z if the axis is along x, else from x.
  Vec<3> unit = Vec<3>::Zero();
  unit[axis_ == 0 ? 1 : 0] = std::cos(angle);
  unit[axis_ == 2 ? 1 : 2] = std::sin(angle);
  return unit;
}

Vec<3> Revolved::placed(double radius, double height, const Vec<3>& arm) const {
  Vec<3> r = radius * arm;
  r[axis_] = height;
  return r;
}

Nearest<3> Revolved::nearest(const Vec<3>& r) const {
  Vec<3> off = r - origin_;
  const double height = off[axis_];
  off[axis_] = 0;
  const double radius = off.norm();
  const Nearest<2> flat = whole_.nearest({radius, height});
  // On the axis the foot may be on either side.
  const double side = flat.foot[0] < 0 ? -1 : 1;
  const Vec<3> out = radius > 0 ? Vec<3>(off / radius) : arm(0);
  return {flat.distance, origin_ + placed(side * flat.foot[0], flat.foot[1], out),
          placed(side * flat.normal[0], flat.normal[1], out), flat.patch};
}

Bounds<3> Revolved::bounds() const {
  const Bounds<2> flat = whole_.bounds();
  Bounds<3> all{Vec<3>::Constant(-flat.high[0]), Vec<3>::Constant(flat.high[0])};
  all.low[axis_] = flat.low[1];
  all.high[axis_] = flat.high[1];
  return {origin_ + all.low, origin_ + all.high};
}

SurfaceMesh Revolved::surface() const {
  SurfaceMesh mesh;
  for (const std::string& name : patches_) mesh.patches.push_back({name, {}});
  const auto ring = [&](const Vec<2>& at) {
    const int first = static_cast<int>(mesh.points.size());
    for (int k = 0; k < (at[0] > 0 ? facets_around : 1); ++k) {
      const Vec<3> r = origin_ + placed(at[0], at[1], arm(2 * pi * k / facets_around));
      mesh.points.push_back({r[0], r[1], r[2]});
    }
    return first;
  };
  // The half's way turns with the liquid on its left; seen so, (radius, angle, height) is a left-handed frame unless
  // arm() turns from x to z about y.
  const bool flipped = axis_ != 1;
  for (const auto& corners : whole_.polygons(profile_tolerance * whole_.bounds().size().maxCoeff()))
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec<2>&a = corners[k].position, &b = corners[(k + 1) % corners.size()].position;
      if (a[0] + b[0] <= 0) continue;
      const int low = ring(a), high = ring(b);
      auto& faces = mesh.patches[static_cast<std::size_t>(corners[k].patch)].faces;
      for (int m = 0; m < facets_around; ++m) {
        const int next = (m + 1) % facets_around;
        std::vector<int> face;
        if (a[0] > 0)
          face = {low + next, low + m};
        else
          face = {low};
        face.push_back(high + (b[0] > 0 ? m : 0));
        if (b[0] > 0) face.push_back(high + next);
        if (flipped) std::reverse(face.begin(), face.end());
        faces.push_back(std::move(face));
      }
    }
  return mesh;
}

std::vector<WallPoint<3>> Revolved::wall_points(int layers, double l0, double reach) const {
  std::vector<WallPoint<3>> points;
  for (int layer = 0; layer < layers; ++layer) {
    bool odd = false;
    for (const LayerPoint& ring : layer_points(whole_, layer, layer + 1 == layers, l0, true)) {
      const double radius = ring.moment / ring.length, around = 2 * pi * ring.moment;
      const bool on_axis = radius < 0.2 * l0;
      const int count = on_axis ? 1 : std::max(3, static_cast<int>(std::lround(2 * pi * radius / l0)));
      const Behind behind = bends_.behind(whole_, ring.position, reach);
      for (int k = 0; k < count; ++k) {
        // Rings beside each other are turned by half a spacing.
        const Vec<3> out = arm((2 * k + odd) * pi / count);
        std::vector<Face<3>> faces;
        for (const Face<2>& face : behind.faces) {
          const Vec<3> normal = placed(face.normal[0], face.normal[1], out);
          faces.push_back({normal, face.offset + normal.dot(origin_)});
        }
        points.push_back({origin_ + placed(on_axis ? 0 : ring.position[0], ring.position[1], out),
                          placed(on_axis ? 0 : behind.normal[0], behind.normal[1], out), around / (count * l0 * l0),
                          layer, behind.patch, std::move(faces)});
      }
      odd = !odd;
    }
  }
  return points;
}

double Revolved::volume() const {
  double sum = 0;
  for (const auto& loop : half_.loops())
    for (const Edge& edge : loop) sum += squares(edge);
  return pi * sum;
}

}  // namespace seiche::solver
