#pragma once
#include <vector>

#include "apps/scene/overrides.hpp"

namespace seiche::apps {

/// Changes how a run that is over is shown: keys of [look], [[look.reference]] (files named from the scene's folder)
/// and output.size. A range "min,max"
/// goes with its quantity: of another one the range is "scene", unless it is given, too. Throws BadScene with all
/// that is wrong, one message a line.
void change_look(Scene& scene, const std::vector<Override>& overrides);

}  // namespace seiche::apps
