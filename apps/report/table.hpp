#pragma once
#include <string>

#include "apps/report.hpp"

namespace seiche::apps::report {

/// How each run ended, its measures and its costs, a column to each run and to each reference, with what each row
/// means below. A row that nothing is known of is left out.
std::string table_html(const Report& report);

}  // namespace seiche::apps::report
