#include "solver/tank/baffles/baffled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

/// Ends that lie on the tank's wall are moved beyond it by the thickness, so that also a slanted or curved wall is met
/// by the whole of the end.
BaffleLine prolonged(BaffleLine baffle, const Shape<2>& tank, double touching) {
  auto& points = baffle.points;
  if (points.size() < 2) return baffle;
  const std::size_t last = points.size() - 1;
  const auto move = [&](Vec<2>& end, const Vec<2>& before) {
    if (tank.nearest(end).distance > -touching) end += (end - before).normalized() * (baffle.thickness + touching);
  };
  const Vec<2> second = points[1], last_but_one = points[last - 1];
  move(points[0], second);
  move(points[last], last_but_one);
  return baffle;
}

/// Where between two points, one within the tank and one not, its wall is.
Vec<2> wall_between(const Shape<2>& tank, Vec<2> inside, Vec<2> outside) {
  for (int k = 0; k < 60; ++k) {
    const Vec<2> middle = 0.5 * (inside + outside);
    (tank.nearest(middle).distance < 0 ? inside : outside) = middle;
  }
  return 0.5 * (inside + outside);
}

}  // namespace

Baffled::Baffled(std::shared_ptr<const Shape<2>> tank, const std::vector<BaffleLine>& baffles, double l0, double reach)
    : tank_(std::move(tank)) {
  for (const BaffleLine& given : baffles) {
    const BaffleLine baffle = prolonged(given, *tank_, touching * l0);
    names_.push_back(baffle.name);
    outlines_.push_back(outline_of(baffle));
    solid_of_.push_back(baffle.thickness > 0 ? static_cast<int>(solids_.size()) : -1);
    if (baffle.thickness > 0) solids_.push_back(polygon(outlines_.back()));
  }
  names_ = numbered(names_);
  for (const auto& patch : tank_->surface().patches) patches_.push_back(patch.name);
  for (std::size_t k = 0; k < outlines_.size(); ++k) {
    const std::size_t before = sides_.size();
    add_sides(static_cast<int>(k), l0);
    if (sides_.size() > before) continue;
    const Vec<2>& at = baffles[k].points.front();
    throw BadParameters(fmt::format("the baffle from ({:.6g}, {:.6g}) m lies outside the tank, which goes {}; move it",
                                    at[0], at[1], tank_->description()));
  }
  std::vector<BaffleFace<2>> faces;
  for (const Side& side : sides_) {
    const Vec<2> beyond = reach * (side.to - side.from).normalized();
    faces.emplace_back(side.from_wall ? Vec<2>(side.from - beyond) : side.from,
                       side.to_wall ? Vec<2>(side.to + beyond) : side.to, side.from_rim, side.to_rim);
  }
  faces_ = std::make_shared<const Baffles<2>>(std::move(faces));
}

void Baffled::add_sides(int baffle, double l0) {
  const auto& outline = outlines_[static_cast<std::size_t>(baffle)];
  const bool is_plate = solid_of_[static_cast<std::size_t>(baffle)] < 0;
  const auto is_inside = [&](const Vec<2>& r) { return tank_->nearest(r).distance < 0; };
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec<2>&a = outline[k], &b = outline[(k + 1) % outline.size()];
    const int parts = std::max(4, static_cast<int>(std::ceil(4 * (b - a).norm() / l0)));
    const auto is_rim = [&](std::size_t corner) { return is_plate && (corner == 0 || corner == outline.size() / 2); };
    Side side{a, b, false, false, is_rim(k), is_rim((k + 1) % outline.size()), baffle};
    const auto keep = [&](const Side& found) {
      if ((found.to - found.from).norm() > touching * l0) sides_.push_back(found);
    };
    for (int m = 0; m < parts; ++m) {
      const Vec<2> here = a + (b - a) * m / parts, next = a + (b - a) * (m + 1) / parts;
      if (is_inside(here) == is_inside(next)) continue;
      if (is_inside(next)) {
        side.from = wall_between(*tank_, next, here);
        side.from_wall = true;
        side.from_rim = false;
        continue;
      }
      Side ended = side;
      ended.to = wall_between(*tank_, here, next);
      ended.to_wall = true;
      ended.to_rim = false;
      keep(ended);
    }
    if (is_inside(b)) keep(side);
  }
}

bool Baffled::is_in_solid(const Vec<2>& r) const {
  const double on_it = 1e-9 * tank_->bounds().size().maxCoeff();
  return std::any_of(solids_.begin(), solids_.end(), [&](const Contour& s) { return s.nearest(r).distance < -on_it; });
}

Nearest<2> Baffled::nearest(const Vec<2>& r) const {
  Nearest<2> wall = tank_->nearest(r);
  for (std::size_t k = 0; k < outlines_.size(); ++k) {
    if (solid_of_[k] < 0) continue;
    const Nearest<2> solid = solids_[static_cast<std::size_t>(solid_of_[k])].nearest(r);
    if (-solid.distance <= wall.distance) continue;
    wall = {-solid.distance, solid.foot, -solid.normal, static_cast<int>(patches_.size() + k)};
  }
  return wall;
}

std::vector<std::vector<Vec<2>>> Baffled::solids() const {
  std::vector<std::vector<Vec<2>>> all;
  for (std::size_t k = 0; k < outlines_.size(); ++k)
    if (solid_of_[k] >= 0) all.push_back(outlines_[k]);
  return all;
}

std::vector<std::vector<Vec<2>>> Baffled::plates() const {
  std::vector<std::vector<Vec<2>>> all;
  for (std::size_t k = 0; k < outlines_.size(); ++k)
    if (solid_of_[k] < 0) all.push_back(outlines_[k]);
  return all;
}

SurfaceMesh Baffled::surface() const {
  SurfaceMesh mesh;
  const SurfaceMesh wall = tank_->surface();
  const auto point = [&](int at) {
    const auto& place = wall.points[static_cast<std::size_t>(at)];
    return Vec<2>(place[0], place[1]);
  };
  // Adds what of a line is in no baffle.
  const auto add_parts = [&](const Vec<2>& from, const Vec<2>& to) {
    std::vector<double> cuts{0, 1};
    for (std::size_t k = 0; k < outlines_.size(); ++k)
      if (solid_of_[k] >= 0)
        for (const double share : crossings_of(from, to, outlines_[k])) cuts.push_back(share);
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      const Vec<2> a = from + cuts[k] * (to - from), b = from + cuts[k + 1] * (to - from);
      if (!((b - a).norm() > 1e-12 * (to - from).norm()) || is_in_solid(0.5 * (a + b))) continue;
      const int first = static_cast<int>(mesh.points.size());
      mesh.points.push_back({a[0], a[1], 0});
      mesh.points.push_back({b[0], b[1], 0});
      mesh.patches.back().faces.push_back({first, first + 1});
    }
  };
  for (const auto& patch : wall.patches) {
    mesh.patches.push_back({patch.name, {}});
    for (const auto& face : patch.faces) add_parts(point(face[0]), point(face[1]));
  }
  for (std::size_t k = 0; k < outlines_.size(); ++k) {
    mesh.patches.push_back({names_[k], {}});
    for (const Side& side : sides_)
      if (side.baffle == static_cast<int>(k)) add_parts(side.to, side.from);
  }
  return mesh;
}

std::vector<WallPoint<2>> Baffled::wall_points(int layers, double l0, double reach) const {
  std::vector<WallPoint<2>> points;
  for (const WallPoint<2>& point : tank_->wall_points(layers, l0, reach)) add_parts(point, l0, points);
  for (std::size_t k = 0; k < sides_.size(); ++k) add_points(sides_[k], static_cast<int>(k), layers, l0, reach, points);
  return points;
}

void Baffled::add_parts(const WallPoint<2>& point, double l0, std::vector<WallPoint<2>>& points) const {
  const Vec<2> way = point.weight * l0 * Vec<2>(-point.normal[1], point.normal[0]), from = point.position - 0.5 * way;
  std::vector<double> cuts{0, 1};
  for (const BaffleFace<2>& face : faces_->faces()) {
    const double before = face.behind(from), after = face.behind(from + way);
    if (before * after >= 0) continue;
    const double share = before / (before - after);
    if (face.holds(from + share * way)) cuts.push_back(share);
  }
  if (cuts.size() == 2) return points.push_back(point);
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double share = cuts[k + 1] - cuts[k];
    if (share < 1e-6) continue;
    WallPoint<2> part = point;
    part.position = from + 0.5 * (cuts[k] + cuts[k + 1]) * way;
    part.weight = share * point.weight;
    points.push_back(part);
  }
}

void Baffled::add_points(const Side& side, int face, int layers, double l0, double reach,
                         std::vector<WallPoint<2>>& points) const {
  const double length = (side.to - side.from).norm();
  const Vec<2> along = (side.to - side.from) / length, normal(-along[1], along[0]);
  const int patch = static_cast<int>(patches_.size()) + side.baffle;
  const auto add = [&](double at, double beyond, bool past_wall, double weight, int k, int layer) {
    const double depth = (k + 0.5) * l0;
    if (std::hypot(beyond, depth) >= reach) return;
    const Vec<2> r = side.from + at * along + depth * normal;
    Vec<2> facing = normal;
    if (past_wall) {
      // Behind the wall, too: there it is the wall's slope that goes on.
      const Nearest<2> wall = tank_->nearest(r);
      if (wall.distance > 0) facing = wall.normal;
    }
    points.push_back({r, facing, weight, layer, patch, {}, face});
  };
  const int count = std::max(1, static_cast<int>(std::lround(length / l0)));
  for (int k = 0; k < layers; ++k) {
    for (int m = 0; m < count; ++m) add((m + 0.5) * length / count, 0, false, length / (count * l0), k, k);
    // Beyond the ends they are as wet as the wall before them is, like the second layer.
    const int layer = std::max(k, 1);
    for (double beyond = 0.5 * l0; beyond < reach; beyond += l0) {
      add(-beyond, beyond, side.from_wall, 1, k, layer);
      add(length + beyond, beyond, side.to_wall, 1, k, layer);
    }
  }
}

}  // namespace seiche::solver
