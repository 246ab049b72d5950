#pragma once
#include <filesystem>

#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// Draws the scene as a run of it starts: tank, liquid, and each degree of freedom along or about its axis, from the
/// pivot, or from the middle of the tank where the pivot is outside of it.
/// @throws render::NoGl
void draw_start(const Scene& scene, const std::filesystem::path& file);

}  // namespace seiche::apps
