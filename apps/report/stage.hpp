#pragma once
#include <filesystem>
#include <string>

#include "apps/report/contents.hpp"

namespace seiche::apps::report {

/// The movie, the stills and what moves through them, as a figure; empty where there are neither.
/// @param folder of the page, from which a movie that is too large to be embedded is linked
std::string stage_html(const Report& report, const std::filesystem::path& folder);

}  // namespace seiche::apps::report
