#pragma once
#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace seiche {

/// A surface as polygons in 3-D and as segments in 2-D, in named patches.
struct SurfaceMesh {
  struct Patch {
    std::string name;  ///< as in "floor"
    /// Of each face its corners, as places in `points`: two in 2-D, with the inside on the left of the way from one to
    /// the other; three or more in 3-D, counter-clockwise as seen from outside.
    std::vector<std::vector<int>> faces;
  };

  std::vector<std::array<double, 3>> points;  ///< [m]; z = 0 in 2-D
  std::vector<Patch> patches;

  /// The ends of the box that holds it [m].
  std::array<double, 3> low() const {
    return ends([](double a, double b) { return std::min(a, b); });
  }
  std::array<double, 3> high() const {
    return ends([](double a, double b) { return std::max(a, b); });
  }
  std::array<double, 3> size() const {
    const auto from = low(), to = high();
    return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
  }

  template <class Of>
  std::array<double, 3> ends(Of of) const {
    std::array<double, 3> end{};
    if (!points.empty()) end = points.front();
    for (const auto& point : points)
      for (std::size_t axis = 0; axis < 3; ++axis) end[axis] = of(end[axis], point[axis]);
    return end;
  }
};

}  // namespace seiche
