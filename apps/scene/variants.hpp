#pragma once
#include <string>
#include <vector>

#include "apps/scene/options.hpp"

// How scenes that differ in some keys are told apart.
namespace seiche::apps {

/// Whether a key says how a run looks or what it writes, and not what is simulated.
bool is_look(const Option& option);

/// As --set takes it.
std::string text_of(const Value& value);

/// What variants are called above their panels, as in "KF3, 5 mm": their values of some keys. A key whose value is the
/// same in all is left out, unless there is nothing else to say.
std::vector<std::string> labels_of(const std::vector<const Scene*>& scenes, const std::vector<const Option*>& keys);

/// What a variant's folder is called for its values of some keys, as in "KF3_spacing-0.005".
std::string folder_of(const Scene& scene, const std::vector<const Option*>& keys);

/// The keys of what is simulated whose values aren't the same in all scenes.
std::vector<const Option*> differences(const std::vector<const Scene*>& scenes);

}  // namespace seiche::apps
