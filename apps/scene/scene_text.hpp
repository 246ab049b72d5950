#pragma once
#include <string>

#include "apps/scene/scene.hpp"

namespace seiche::apps {

/// Every key with its value, as a scene file that reads back to the same scene.
std::string scene_text(const Scene& scene);

/// The same with what each key means and takes, as comments.
std::string explained_scene_text(const Scene& scene);

/// Of scene_text() and the samples of its motion file and its references, 16 hexadecimal digits: the same for two
/// scenes that differ in comments or layout only.
std::string scene_hash(const Scene& scene);

}  // namespace seiche::apps
