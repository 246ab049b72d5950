#pragma once
#include <string>
#include <string_view>

#include "apps/scene/stl/stl_builder.hpp"

namespace seiche::apps {

/// Whether the file begins as a text STL file does: with "solid", and with no zero byte.
bool is_text_stl(std::string_view bytes);

/// A text file of one or more solids, words in either case:
///   solid NAME  {facet normal n n n  outer loop  {vertex x y z} x 3  endloop  endfacet}  endsolid NAME
/// Normals are not read. Throws BadScene with file:line.
void read_text_stl(std::string_view text, const std::string& file, StlBuilder& builder);

}  // namespace seiche::apps
