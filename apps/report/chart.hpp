#pragma once
#include <string>

#include "apps/report/curves.hpp"

namespace seiche::apps::report {

/// A piece of a line with the class that colours and dashes it, for a key.
std::string line_sample(const std::string& style);

/// The class of a run's or a reference's line, as in "v0" or "r1"; "all" where it is every run's.
std::string line_style(const Trace& trace);

/// The chart as a figure whose curves are vectors. Its axes stretch with the page, its letters don't.
std::string chart_html(const Chart& chart, bool alone);

}  // namespace seiche::apps::report
