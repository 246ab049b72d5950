#pragma once
#include <string>

#include "apps/report/contents.hpp"

namespace seiche::apps::report {

/// How each run ended, its measures and its costs, a row to each run and to each reference, with what each measure
/// means below.
std::string table_html(const Report& report);

}  // namespace seiche::apps::report
