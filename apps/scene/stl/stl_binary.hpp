#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "apps/scene/stl/stl_builder.hpp"

namespace seiche::apps {

/// How long a binary STL file with that many triangles is [bytes].
constexpr std::uint64_t stl_size(std::uint64_t triangles) { return 84 + 50 * triangles; }

/// How many triangles the file's head promises; 0 where it ends before.
std::uint32_t stl_count(std::string_view bytes);

/// A binary file: 80 bytes, the number of triangles, and of each a normal, three corners (32-bit floats, the least byte
/// first) and two bytes. Normals are not read. Throws BadScene with file:byte.
void read_binary_stl(std::string_view bytes, const std::string& file, StlBuilder& builder);

}  // namespace seiche::apps
