#pragma once
#include <string>
#include <string_view>

#include "apps/scene/stl/stl_builder.hpp"
#include "solver/length_unit.hpp"

namespace seiche::apps {

/// Reads the triangles of an STL file, text or binary: binary if its size is what its head says, whatever it begins
/// with. Each solid of a text file is a patch by its name. Throws BadScene with the file and its line or byte, what is
/// wrong and what to do: also where no triangle is left.
StlSurface read_stl_file(const std::string& file, LengthUnit unit);

/// The same from a file's bytes; `file` is its name in messages.
StlSurface parse_stl(std::string_view bytes, const std::string& file, LengthUnit unit);

}  // namespace seiche::apps
