#pragma once
#include <string>

#include "apps/scene/values.hpp"
#include "solver/choice.hpp"

namespace seiche::apps {

/// A tank's points from CSV text: columns x and y of a prism, z (height) and r (radius) of a body of revolution, in m,
/// cm or mm. Throws BadScene with file:line of the first thing wrong.
Points parse_points(const std::string& text, const std::string& file, TankShape shape);

/// The same from a file.
Points read_points_file(const std::string& file, TankShape shape);

}  // namespace seiche::apps
