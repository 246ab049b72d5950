#pragma once
#include <vector>

#include "solver/choice.hpp"
#include "solver/tank/edge.hpp"

namespace seiche::solver {

/// The profile of a head on a shell of that radius, by (radius, height above the shell's end) [m]: edges from the shell
/// to the axis. Tangent to the shell but where flat.
/// - elliptical: 2:1, its height half the radius; of circular arcs within 1e-6 of the radius
/// - torispherical: Kloepper's, crown radius = diameter, knuckle radius = 0.1 diameter (DIN 28011, wall not thick)
std::vector<Edge> head_profile(Head head, double radius, int patch);

/// The arcs, two at most, that go from `from` to `to` with the given unit tangents there, themselves tangent to each
/// other (biarc with equal arms, Bolton 1975).
std::vector<Edge> biarc(const Vec<2>& from, const Vec<2>& along_from, const Vec<2>& to, const Vec<2>& along_to,
                        int patch);

}  // namespace seiche::solver
