#pragma once
#include <filesystem>
#include <string>

#include "apps/common/csv.hpp"
#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// Reads the series of each [[look.reference]], whose files are named from `folder`, and gives those without a label
/// the file's name. Throws BadScene. The scene has all sensors that they name.
void read_references(Scene& scene, const std::filesystem::path& folder);

/// A column of a table over its column "t" or "t [s]", from a time [s] on. `column` may leave the unit out of a title
/// that has one; it must then be `unit`. Empty cells are gaps. Throws BadScene with file:line, what is wrong and what
/// was expected.
render::Series reference_series(const Csv& table, const std::string& column, const std::string& unit, double from = 0);

}  // namespace seiche::apps
