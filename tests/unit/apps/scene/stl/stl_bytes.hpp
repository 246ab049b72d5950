#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace seiche::test {

using Triangle = std::array<std::array<float, 3>, 3>;

inline std::string bytes_of(std::uint32_t value) {
  std::string bytes;
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>(value >> (8 * k) & 255);
  return bytes;
}

/// A binary STL file.
inline std::string binary_stl(const std::vector<Triangle>& triangles, std::string head = "") {
  head.resize(80, ' ');
  std::string bytes = head + bytes_of(static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle& triangle : triangles) {
    bytes.append(12, '\0');
    for (const auto& corner : triangle)
      for (const float x : corner) bytes += bytes_of(std::bit_cast<std::uint32_t>(x));
    bytes.append(2, '\0');
  }
  return bytes;
}

/// A tetrahedron.
inline std::vector<Triangle> tetrahedron() {
  const std::array<float, 3> o{0, 0, 0}, x{1, 0, 0}, y{0, 2, 0}, z{0, 0, 0.1F};
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

/// A box from the origin, as binary STL.
inline std::string stl_box(float x, float y, float z) {
  std::vector<Triangle> triangles;
  const std::array<float, 3> size{x, y, z};
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool far : {false, true}) {
      std::array<std::array<float, 3>, 4> corners{};
      for (std::size_t k = 0; k < 4; ++k) {
        corners[k][axis] = far ? size[axis] : 0;
        corners[k][(axis + 1) % 3] = k == 1 || k == 2 ? size[(axis + 1) % 3] : 0;
        corners[k][(axis + 2) % 3] = k >= 2 ? size[(axis + 2) % 3] : 0;
      }
      if (!far) std::swap(corners[1], corners[3]);
      triangles.push_back({corners[0], corners[1], corners[2]});
      triangles.push_back({corners[0], corners[2], corners[3]});
    }
  return binary_stl(triangles);
}

/// The tetrahedron in two solids of a text file.
inline std::string text_stl() {
  const std::string head = "facet normal nan 0 -1e0\n outer loop\n", tail = " endloop\nendfacet\n";
  const std::string o = "vertex 0 0 -0\n", x = "vertex +1 0 0\n", y = "vertex 0 2.0e0 0\n", z = "vertex 0 0 .1\n";
  return "solid floor of it \r\n" + head + o + y + x + tail + "endsolid floor of it\nsolid\n" + head + o + x + z +
         tail + head + o + z + y + tail + "FACET NORMAL 0 0 0 OUTER LOOP " + x + y + z + tail + "endsolid";
}

}  // namespace seiche::test
