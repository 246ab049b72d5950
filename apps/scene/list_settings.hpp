#pragma once
#include <vector>

#include "apps/scene/setting.hpp"

namespace seiche::apps {

/// Replaces a list of the scene by the tables it is given. Values that won't do, keys that are required and missing,
/// and names that are taken are added to the complaints.
void put_list(const ListSetting& setting, Scene& scene, std::vector<Complaint>& complaints);

}  // namespace seiche::apps
