#include "solver/tank/baffles/baffled_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/errors.hpp"
#include "solver/tank/baffles/body_surface.hpp"
#include "solver/tank/baffles/sides.hpp"

namespace seiche::solver {

BaffledBody::BaffledBody(std::shared_ptr<const Shape<3>> tank, std::vector<FlatBaffle> baffles, double l0, double reach)
    : tank_(std::move(tank)), baffles_(std::move(baffles)), l0_(l0) {
  first_patch_ = static_cast<int>(tank_->surface().patches.size());
  std::vector<BaffleFace<3>> faces;
  for (const FlatBaffle& baffle : baffles_) {
    if (!is_in_tank(baffle, *tank_, l0))
      throw BadParameters(
          fmt::format("the {} about ({:.6g}, {:.6g}, {:.6g}) m lies outside the tank, which goes {}; move it",
                      baffle.name, baffle.origin[0], baffle.origin[1], baffle.origin[2], tank_->description()));
    const int number = static_cast<int>(rims_.size());
    names_.push_back(baffle.name);
    rims_.push_back(rims_of(baffle, *tank_, l0, touching * l0));
    // Whole spacings, which keep the places of the points behind it.
    longer_.push_back(prolonged(baffle, rims_.back(), std::ceil((reach + baffle.thickness) / l0) * l0));
    for (BaffleFace<3>& face : sides_of(longer_.back(), rims_.back())) {
      faces.push_back(std::move(face));
      baffle_of_.push_back(number);
    }
  }
  names_ = numbered(names_);
  faces_ = std::make_shared<const Baffles<3>>(std::move(faces));
}

Nearest<3> BaffledBody::nearest(const Vec<3>& r) const {
  Nearest<3> wall = tank_->nearest(r);
  for (std::size_t k = 0; k < longer_.size(); ++k) {
    if (longer_[k].thickness == 0) continue;
    const Nearest<3> solid = longer_[k].nearest(r);
    if (-solid.distance <= wall.distance) continue;
    wall = {-solid.distance, solid.foot, -solid.normal, first_patch_ + static_cast<int>(k)};
  }
  return wall;
}

SurfaceMesh BaffledBody::surface() const {
  SurfaceMesh mesh = tank_->surface();
  const auto put = [&](const Polygons3& polygons, SurfaceMesh::Patch& patch) {
    for (const Polygon3& polygon : polygons) {
      auto& face = patch.faces.emplace_back();
      for (const Vec<3>& r : polygon) {
        face.push_back(static_cast<int>(mesh.points.size()));
        mesh.points.push_back({r[0], r[1], r[2]});
      }
    }
  };
  const auto is_thick = [](const FlatBaffle& baffle) { return baffle.thickness > 0; };
  if (std::any_of(longer_.begin(), longer_.end(), is_thick)) {
    const std::vector<std::array<double, 3>> points = std::exchange(mesh.points, {});
    for (SurfaceMesh::Patch& patch : mesh.patches) {
      Polygons3 polygons;
      for (const auto& face : std::exchange(patch.faces, {})) {
        Polygon3& polygon = polygons.emplace_back();
        for (const int k : face) polygon.emplace_back(points[static_cast<std::size_t>(k)].data());
      }
      for (const FlatBaffle& baffle : longer_)
        if (is_thick(baffle)) cut_out_baffle(baffle, polygons);
      put(polygons, patch);
    }
  }
  for (std::size_t k = 0; k < baffles_.size(); ++k) {
    SurfaceMesh::Patch patch{names_[k], {}};
    Polygons3 polygons = polygons_of(baffles_[k], rims_[k], *tank_, l0_, touching * l0_);
    for (std::size_t other = 0; other < longer_.size(); ++other)
      if (other != k && is_thick(longer_[other])) cut_out_baffle(longer_[other], polygons);
    put(polygons, patch);
    mesh.patches.push_back(std::move(patch));
  }
  return mesh;
}

std::vector<WallPoint<3>> BaffledBody::wall_points(int layers, double l0, double reach) const {
  std::vector<WallPoint<3>> points = tank_->wall_points(layers, l0, reach);
  for (std::size_t k = 0; k < baffle_of_.size(); ++k)
    SidePoints{*tank_, layers, l0, reach, first_patch_ + baffle_of_[k]}.add(faces_->faces()[k], static_cast<int>(k),
                                                                            points);
  return points;
}

}  // namespace seiche::solver
