#include "solver/tank/shapes/built_in.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

void check_positive(const char* what, double length) {
  if (!(length > 0) || !std::isfinite(length))
    throw BadParameters(fmt::format("the tank's {} is {:.6g} m; it must be greater than 0", what, length));
}

std::vector<std::string> numbered(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < count; ++k) names.push_back(fmt::format("edge_{}", k + 1));
  return names;
}

void check_chamfer(const char* what, const Vec<2>& chamfer, double breadth) {
  if (!(chamfer[0] >= 0) || !(chamfer[1] >= 0) || (chamfer[0] > 0) != (chamfer[1] > 0) || chamfer[0] > 0.5 * breadth)
    throw BadParameters(
        fmt::format("the tank's {} is {:.6g} by {:.6g} m; give it two lengths greater than 0, the first up to half the "
                    "breadth ({:.6g} m), or 0",
                    what, chamfer[0], chamfer[1], 0.5 * breadth));
}

/// Down a head that stands below a shell: the upper one's image, the other way.
std::vector<Edge> turned_over(const std::vector<Edge>& edges, int patch) {
  std::vector<Edge> all;
  for (auto edge = edges.rbegin(); edge != edges.rend(); ++edge)
    all.push_back({{edge->to[0], -edge->to[1]}, {edge->from[0], -edge->from[1]}, edge->bulge, patch});
  return all;
}

std::vector<Edge> raised(std::vector<Edge> edges, double by) {
  for (Edge& edge : edges) edge.from[1] += by, edge.to[1] += by;
  return edges;
}

/// Closes a profile from the axis to the axis along it.
Contour closed_on_axis(std::vector<Edge> profile) {
  profile.push_back({profile.back().to, profile.front().from, 0, 0});
  return Contour({std::move(profile)});
}

}  // namespace

Extruded prism(const std::vector<Vec<2>>& points, double width) {
  check_positive("width", width);
  return {Section(polygon(points), numbered(points.size())), 0, width};
}

Extruded membrane(double breadth, double height, const Vec<2>& lower_chamfer, const Vec<2>& upper_chamfer,
                  double length) {
  check_positive("breadth", breadth);
  check_positive("height", height);
  check_positive("length", length);
  check_chamfer("lower chamfer", lower_chamfer, breadth);
  check_chamfer("upper chamfer", upper_chamfer, breadth);
  if (lower_chamfer[1] + upper_chamfer[1] > height)
    throw BadParameters(
        fmt::format("the tank's chamfers are {:.6g} and {:.6g} m high, more than its height of {:.6g} m",
                    lower_chamfer[1], upper_chamfer[1], height));
  const double half = 0.5 * breadth;
  const Vec<2>&low = lower_chamfer, &up = upper_chamfer;
  const std::vector<std::pair<const char*, Vec<2>>> corners{
      {"floor", {-half + low[0], 0}},    {"lower_right", {half - low[0], 0}},
      {"right", {half, low[1]}},         {"upper_right", {half, height - up[1]}},
      {"roof", {half - up[0], height}},  {"upper_left", {-half + up[0], height}},
      {"left", {-half, height - up[1]}}, {"lower_left", {-half, low[1]}}};
  std::vector<Edge> edges;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vec<2>&from = corners[k].second, &to = corners[(k + 1) % corners.size()].second;
    if ((to - from).norm() < 1e-12 * breadth) continue;
    edges.push_back({from, to, 0, static_cast<int>(names.size())});
    names.emplace_back(corners[k].first);
  }
  // A side that is left out by rounding leaves no gap.
  for (std::size_t k = 0; k < edges.size(); ++k) edges[(k + 1) % edges.size()].from = edges[k].to;
  return {Section(Contour({std::move(edges)}), std::move(names)), -0.5 * length, 0.5 * length};
}

Revolved cylinder(double radius, double length, Axis along, Head ends) {
  const int axis = static_cast<int>(along);
  check_positive("radius", radius);
  check_positive("length", length);
  const std::vector<Edge> head = head_profile(ends, radius, 2);
  const double height = head.back().to[1];
  std::vector<Edge> profile = raised(turned_over(head, 1), height);
  profile.push_back({{radius, height}, {radius, height + length}, 0, 0});
  const std::vector<Edge> upper = raised(head, height + length);
  profile.insert(profile.end(), upper.begin(), upper.end());
  for (std::size_t k = 1; k < profile.size(); ++k) profile[k].from = profile[k - 1].to;
  const char* names[][2] = {{"left_head", "right_head"}, {"lower_head", "upper_head"}, {"near_head", "far_head"}};
  Vec<3> origin = Vec<3>::Zero();
  if (axis != 1) {
    origin[1] = radius;
    origin[axis] = -0.5 * length - height;
  }
  return {closed_on_axis(std::move(profile)), {"shell", names[axis][0], names[axis][1]}, axis, origin};
}

Revolved sphere(double radius) {
  check_positive("radius", radius);
  return {closed_on_axis({{{0, 0}, {0, 2 * radius}, 1, 0}}), {"shell"}, 1, Vec<3>::Zero()};
}

Revolved revolve(const std::vector<Vec<2>>& points) {
  if (points.size() < 2)
    throw BadParameters(fmt::format("the tank's profile has {} points; give two at least", points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!(points[k][1] >= 0))
      throw BadParameters(fmt::format("the tank's profile: point {} has the radius {:.6g} m; none may be negative",
                                      k + 1, points[k][1]));
  const auto lowest =
      std::min_element(points.begin(), points.end(), [](const Vec<2>& a, const Vec<2>& b) { return a[0] < b[0]; });
  const auto at = [&](const Vec<2>& point) { return Vec<2>(point[1], point[0] - (*lowest)[0]); };
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < points.size(); ++k)
    edges.push_back({at(points[k]), at(points[k + 1]), 0, static_cast<int>(k)});
  std::vector<std::string> names = numbered(edges.size());
  if (edges.front().from == edges.back().to) return {Contour({std::move(edges)}), std::move(names), 1, Vec<3>::Zero()};
  if (const Vec<2> first = edges.front().from; first[0] > 0) {
    edges.insert(edges.begin(), {{0, first[1]}, first, 0, static_cast<int>(names.size())});
    names.emplace_back("first_end");
  }
  if (const Vec<2> last = edges.back().to; last[0] > 0) {
    edges.push_back({last, {0, last[1]}, 0, static_cast<int>(names.size())});
    names.emplace_back("last_end");
  }
  return {closed_on_axis(std::move(edges)), std::move(names), 1, Vec<3>::Zero()};
}

}  // namespace seiche::solver
