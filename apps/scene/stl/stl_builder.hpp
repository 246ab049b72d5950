#pragma once
#include <array>
#include <map>
#include <string>
#include <string_view>

#include "solver/surface_mesh.hpp"

namespace seiche::apps {

/// What an STL file holds.
struct StlSurface {
  SurfaceMesh mesh;    ///< triangles, in a patch for each name of a solid [m]
  int degenerate = 0;  ///< triangles with two corners in one place, which are left out
};

/// Collects the triangles of a file.
class StlBuilder {
 public:
  /// @param metres in the file's unit of length
  explicit StlBuilder(double metres) : metres_(metres) {}

  /// The triangles that follow are of this solid; those of one name share a patch. Bytes that aren't printable ASCII
  /// become '?'; without a name it is "wall", or "wall-2" for the second.
  void begin_solid(std::string_view name);

  /// @param corners in the file's unit, finite
  void add(const std::array<std::array<double, 3>, 3>& corners);

  /// Patches without a triangle are left out.
  StlSurface result() &&;

 private:
  int place_of(const std::array<double, 3>& point);

  double metres_;
  int unnamed_ = 0;
  std::size_t patch_ = 0;
  std::map<std::array<double, 3>, int> places_;
  StlSurface surface_;
};

}  // namespace seiche::apps
