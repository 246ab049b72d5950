#pragma once
#include <cmath>
#include <numbers>
#include <random>

#include "solver/surface_mesh.hpp"
#include "solver/tank/mesh/mesh_tank.hpp"

namespace seiche::solver::test {

/// Two triangles.
inline void add_square(SurfaceMesh& mesh, int patch, int a, int b, int c, int d) {
  mesh.patches[patch].faces.push_back({a, b, c});
  mesh.patches[patch].faces.push_back({a, c, d});
}

/// A box in a patch of its own, facing outwards.
inline void add_box(SurfaceMesh& mesh, const std::string& name, const Vec<3>& low, const Vec<3>& high) {
  const int first = static_cast<int>(mesh.points.size()), patch = static_cast<int>(mesh.patches.size());
  mesh.patches.push_back({name, {}});
  for (int k = 0; k < 8; ++k)
    mesh.points.push_back({k & 1 ? high[0] : low[0], k & 2 ? high[1] : low[1], k & 4 ? high[2] : low[2]});
  const int sides[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& s : sides) add_square(mesh, patch, first + s[0], first + s[1], first + s[2], first + s[3]);
}

inline SurfaceMesh box(const Vec<3>& size) {
  SurfaceMesh mesh;
  add_box(mesh, "wall", Vec<3>::Zero(), size);
  return mesh;
}

/// What a profile (radius, y) makes that goes from the axis to the axis, in as many facets, patch k from corner k.
inline SurfaceMesh turned(const std::vector<Vec<2>>& profile, int facets) {
  SurfaceMesh mesh;
  std::vector<int> first;
  for (const Vec<2>& at : profile) {
    first.push_back(static_cast<int>(mesh.points.size()));
    for (int k = 0; k < (at[0] > 0 ? facets : 1); ++k) {
      const double angle = 2 * std::numbers::pi * k / facets;
      mesh.points.push_back({at[0] * std::cos(angle), at[1], -at[0] * std::sin(angle)});
    }
  }
  for (std::size_t ring = 0; ring + 1 < profile.size(); ++ring) {
    mesh.patches.push_back({"ring " + std::to_string(ring), {}});
    auto& faces = mesh.patches.back().faces;
    for (int k = 0; k < facets; ++k) {
      const int next = (k + 1) % facets;
      const auto low = [&](int at) { return first[ring] + (profile[ring][0] > 0 ? at : 0); };
      const auto high = [&](int at) { return first[ring + 1] + (profile[ring + 1][0] > 0 ? at : 0); };
      if (profile[ring][0] > 0) faces.push_back({low(k), low(next), high(next)});
      if (profile[ring + 1][0] > 0) faces.push_back({low(k), high(next), high(k)});
    }
  }
  return mesh;
}

inline SurfaceMesh sphere_mesh(double radius, int facets) {
  std::vector<Vec<2>> profile;
  for (int k = 0; k <= facets / 2; ++k) {
    const double angle = 2 * std::numbers::pi * k / facets;
    const bool pole = k == 0 || k == facets / 2;
    profile.emplace_back(pole ? 0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return turned(profile, facets);
}

inline SurfaceMesh cylinder_mesh(double radius, double height, int facets) {
  return turned({{0, 0}, {radius, 0}, {radius, height}, {0, height}}, facets);
}

/// Turns about half of the triangles over.
inline void turn_some(SurfaceMesh& mesh) {
  std::mt19937 random(7);
  for (auto& patch : mesh.patches)
    for (auto& face : patch.faces)
      if (random() % 2) std::swap(face[0], face[1]);
}

}  // namespace seiche::solver::test
