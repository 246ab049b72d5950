#pragma once
#include <filesystem>
#include <vector>

#include "apps/scene/setting.hpp"

// A scene may say where its tank's points are, and how full it is, in several ways: here they become parameters.
namespace seiche::apps {

/// Puts the tank's shape into the scene, with the measures that it starts from. Call before other keys of the tank;
/// what is wrong with it is told where it is put like any key.
void put_shape(const std::vector<Setting>& settings, Scene& scene);

/// Leaves of the keys that tell the level the one that was given: what the command line says replaces the file's.
/// Complains where a file gives several. A tank that is no box has no level of its own.
void put_one_level(const std::vector<Setting>& settings, Scene& scene, std::vector<Complaint>& complaints);

/// Reads the tank's points or its mesh where they are in a file, and finds the depth where the scene tells a share or a
/// volume.
/// @param folder of the scene
/// Throws BadScene or BadParameters.
void settle_tank(Scene& scene, const std::filesystem::path& folder);

}  // namespace seiche::apps
