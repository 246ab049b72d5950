#pragma once
#include <filesystem>
#include <string>

#include "apps/report/contents.hpp"

namespace seiche::apps::report {

/// The whole page, HTML. @param folder that it will stand in
std::string page(const Report& report, const std::filesystem::path& folder);

}  // namespace seiche::apps::report
