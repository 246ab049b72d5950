#pragma once
#include <functional>
#include <string>

#include "apps/report.hpp"

namespace seiche::apps::report {

/// As in "5 mm", "0.6 m", their space one that doesn't break.
std::string length_text(double metres);

/// The liquid, its tank and how it moves, in one sentence.
std::string tank_sentence(const Scene& scene);

/// As in "survived 3 s", "stopped at 0.229 s: 61 of 1200 fluid particles leaked".
std::string outcome_text(const ReportRun& run);

/// What `text` says of each run, each said once, parted by commas.
std::string of_all(const Report& report, const std::function<std::string(const ReportRun&)>& text);

}  // namespace seiche::apps::report
