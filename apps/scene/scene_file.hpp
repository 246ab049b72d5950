#pragma once
#include <string>
#include <vector>

#include "apps/common/errors.hpp"
#include "apps/scene/overrides.hpp"
#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// Reads a scene: the preset first, then the file's keys, then the overrides; of two overrides of a key the last one
/// wins. Then reads its motion file and its references, whose paths start from the scene's folder, and checks what
/// concerns several keys at once. Throws BadScene.
Scene read_scene(const std::string& file, const std::vector<Override>& overrides);

/// The same from a file's text; `file` is its name in messages and gives the scene's name.
Scene parse_scene(const std::string& toml, const std::string& file, const std::vector<Override>& overrides);

}  // namespace seiche::apps
