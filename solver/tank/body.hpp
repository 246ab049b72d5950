#pragma once
#include <variant>

#include "solver/parameters.hpp"
#include "solver/tank/mesh/mesh_tank.hpp"
#include "solver/tank/shapes/extruded.hpp"
#include "solver/tank/shapes/revolved.hpp"

namespace seiche::solver {

/// A tank in 3-D, by how its form is known.
using Body = std::variant<Extruded, Revolved, MeshTank>;

/// The tank that a scene's measures make; one that is 2-D has the depth 1 m along z. Throws BadParameters.
Body tank_body(const Parameters& p);

/// The section of a tank whose run is 2-D. Throws BadParameters.
Section tank_section(const Parameters& p);

}  // namespace seiche::solver
