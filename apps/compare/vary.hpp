#pragma once
#include <string>
#include <vector>

#include "apps/options.hpp"
#include "apps/overrides.hpp"
#include "apps/scene.hpp"

namespace seiche::apps::compare {

/// A key and the values that it takes in turn.
struct Vary {
  const Option* option = nullptr;
  std::vector<Override> values;  ///< at least one; each says "--vary KEY=VALUE" in messages
};

/// The argument of one --vary, "KEY=VALUE,VALUE,...". Throws std::invalid_argument for a key that is none, or that
/// says how runs look and not what is simulated, and for values that are missing.
Vary parse_vary(const std::string& text);

/// Every combination of the values, the last key's changing fastest. Throws std::invalid_argument for a key that is
/// varied twice, or that `fixed` sets too, and for more combinations than a picture has panels.
std::vector<std::vector<Override>> combinations(const std::vector<Vary>& varied, const std::vector<Override>& fixed);

/// Whether a key says how a run looks or what it writes, and not what is simulated.
bool is_look(const Option& option);

/// What a variant is called for its values of some keys: above its panel, as in "KF3, 5 mm", and as a folder, as in
/// "KF3_spacing-0.005".
std::string label_of(const Scene& scene, const std::vector<const Option*>& keys);
std::string folder_of(const Scene& scene, const std::vector<const Option*>& keys);

/// The keys of what is simulated whose values aren't the same in all scenes.
std::vector<const Option*> differences(const std::vector<const Scene*>& scenes);

}  // namespace seiche::apps::compare
