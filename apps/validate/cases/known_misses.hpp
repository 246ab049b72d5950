#pragma once
#include <vector>

#include "apps/validate/known_misses.hpp"

namespace seiche::apps::validate {

/// Figures of all_cases() that miss their targets: work to do, but no reason to stop a release. Each has a bound a
/// little beyond what it comes to now; with `--quick` those that aren't measured don't count.
const std::vector<KnownMissOf>& known_misses();

}  // namespace seiche::apps::validate
