#include "apps/scene/stl/stl_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "apps/common/errors.hpp"
#include "apps/scene/stl/stl_binary.hpp"
#include "apps/scene/stl/stl_text.hpp"

namespace seiche::apps {

StlSurface parse_stl(std::string_view bytes, const std::string& file, LengthUnit unit) {
  if (bytes.empty()) throw BadScene(fmt::format("{}: an empty file; expected an STL file", file));
  StlBuilder builder(metres(unit));
  const bool has_binary_size = bytes.size() > stl_size(0) && bytes.size() == stl_size(stl_count(bytes));
  if (!has_binary_size && is_text_stl(bytes))
    read_text_stl(bytes, file, builder);
  else
    read_binary_stl(bytes, file, builder);
  StlSurface surface = std::move(builder).result();
  if (surface.mesh.patches.empty())
    throw BadScene(
        fmt::format("{}: no triangle with three corners in different places{}; export it with the tank's surface", file,
                    surface.degenerate > 0 ? fmt::format(", but {} without", surface.degenerate) : ""));
  return surface;
}

StlSurface read_stl_file(const std::string& file, LengthUnit unit) {
  // Opening a folder succeeds, reading it throws.
  std::ifstream in(file, std::ios::binary);
  if (!in || std::filesystem::is_directory(file))
    throw BadScene(
        fmt::format("{}: this STL file {}", file, std::filesystem::exists(file) ? "can't be read" : "isn't there"));
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return parse_stl(bytes, file, unit);
}

}  // namespace seiche::apps
