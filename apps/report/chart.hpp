#pragma once
#include <string>

#include "apps/report/curves.hpp"

namespace seiche::apps::report {

/// A line of a chart: its class colours and dashes it.
struct LineStyle {
  std::string name;  ///< of the class, as in "v0" of a run, "r1" of a reference, "all" where it is every run's
  bool reference = false;
};

LineStyle run_line(std::size_t number);
LineStyle reference_line(std::size_t number);
LineStyle line_style(const Trace& trace);

/// A piece of a line, for a key.
std::string line_sample(const LineStyle& style);

/// The chart as a figure whose curves are vectors. Its axes stretch with the page, its letters don't.
std::string chart_html(const Chart& chart, bool alone);

}  // namespace seiche::apps::report
