#include "solver/tank/shapes/head.hpp"

#include <cmath>
#include <numbers>

namespace seiche::solver {
namespace {

using std::numbers::pi;

/// The arc that leaves `from` along a unit tangent and comes to `to`: it turns by twice the angle to its chord.
Edge arc(const Vec<2>& from, const Vec<2>& along, const Vec<2>& to, int patch) {
  const Vec<2> chord = to - from;
  return {from, to, std::tan(0.5 * std::atan2(cross(along, chord), along.dot(chord))), patch};
}

std::vector<Edge> elliptical(double radius, int patch) {
  constexpr int pieces = 30;
  std::vector<Edge> edges;
  const auto at = [&](int k) {
    const double t = 0.5 * pi * k / pieces;
    return k == pieces ? Vec<2>(0, 0.5 * radius) : Vec<2>(radius * std::cos(t), 0.5 * radius * std::sin(t));
  };
  const auto along = [&](int k) {
    const double t = 0.5 * pi * k / pieces;
    return k == pieces ? Vec<2>(-1, 0) : Vec<2>(Vec<2>(-std::sin(t), 0.5 * std::cos(t)).normalized());
  };
  for (int k = 0; k < pieces; ++k)
    for (const Edge& edge : biarc(at(k), along(k), at(k + 1), along(k + 1), patch)) edges.push_back(edge);
  return edges;
}

std::vector<Edge> torispherical(double radius, int patch) {
  const double crown = 2 * radius, knuckle = 0.2 * radius;
  // The crown's centre is on the axis, crown - knuckle from the knuckle's; both arcs meet on the line through them.
  const double below = std::sqrt((crown - knuckle) * (crown - knuckle) - (radius - knuckle) * (radius - knuckle));
  const double angle = std::asin((radius - knuckle) / (crown - knuckle));
  const Vec<2> joint(crown * std::sin(angle), crown * std::cos(angle) - below);
  return {{{radius, 0}, joint, std::tan(0.25 * (0.5 * pi - angle)), patch},
          {joint, {0, crown - below}, std::tan(0.25 * angle), patch}};
}

}  // namespace

std::vector<Edge> biarc(const Vec<2>& from, const Vec<2>& along_from, const Vec<2>& to, const Vec<2>& along_to,
                        int patch) {
  // The arms d satisfy |to - from - d (t0 + t1)| = 2 d.
  const Vec<2> v = to - from, t = along_from + along_to;
  const double a = 2 * (1 - along_from.dot(along_to)), b = v.dot(t), c = v.squaredNorm();
  const double arm = c / (b + std::sqrt(b * b + a * c));
  const Vec<2> joint = 0.5 * (from + arm * along_from + to - arm * along_to);
  const Vec<2> along_joint = (to - arm * along_to - from - arm * along_from).normalized();
  return {arc(from, along_from, joint, patch), arc(joint, along_joint, to, patch)};
}

std::vector<Edge> head_profile(Head head, double radius, int patch) {
  switch (head) {
    case Head::flat:
      return {{{radius, 0}, {0, 0}, 0, patch}};
    case Head::hemispherical:
      return {{{radius, 0}, {0, radius}, std::tan(pi / 8), patch}};
    case Head::elliptical:
      return elliptical(radius, patch);
    case Head::torispherical:
      return torispherical(radius, patch);
  }
  return {};
}

}  // namespace seiche::solver
