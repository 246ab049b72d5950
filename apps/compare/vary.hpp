#pragma once
#include <string>
#include <vector>

#include "apps/scene/options.hpp"
#include "apps/scene/overrides.hpp"
#include "apps/scene/scene.hpp"

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

}  // namespace seiche::apps::compare
