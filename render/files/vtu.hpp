#pragma once
#include <filesystem>

#include "render/files/provenance.hpp"

namespace seiche::render {

/// One frame for ParaView: a vertex for each particle in the frame's order, with velocity, pressure, number_density,
/// kind, free_surface and id; as field data TimeValue, tank_displacement, tank_velocity and the notes. Positions are in
/// the tank's frame. Values must be finite: VTK can't read others' range back. Throws std::runtime_error.
void write_vtu(const std::filesystem::path& file, const Frame& frame, const Notes& notes);

}  // namespace seiche::render
