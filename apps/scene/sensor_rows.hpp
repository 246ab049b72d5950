#pragma once
#include <vector>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// The list with each table that has `from`, `to` and `count` replaced by those of its sensors: NAME_1 at `from` to
/// NAME_count at `to`, evenly apart, everything else as in the table. Rows that won't do are added to the complaints,
/// and left out.
ListSetting rows_laid_out(const ListSetting& setting, std::vector<Complaint>& complaints);

}  // namespace seiche::apps
