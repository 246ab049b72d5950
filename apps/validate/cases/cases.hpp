#pragma once
#include <vector>

#include "apps/validate/case.hpp"

namespace seiche::apps::validate {

/// All of the program's, in the order of the table.
std::vector<Case> all_cases();

Findings still_tank(Bench& bench);
Findings pan2008(Bench& bench);
Findings standing_wave(Bench& bench);
Findings dam_break(Bench& bench);
Findings roll(Bench& bench);
Findings paper(Bench& bench);
Findings tanks(Bench& bench);
Findings tanks_3d(Bench& bench);
Findings tanks_moved(Bench& bench);
Findings motions(Bench& bench);
Findings spheric10(Bench& bench);

}  // namespace seiche::apps::validate
