#pragma once
#include <string>
#include <vector>

#include "apps/validate/case.hpp"

namespace seiche::apps::validate {

/// How a case came out.
struct Outcome {
  std::string name;
  Findings findings;
  std::string failure;  ///< why it has no findings; empty if it has

  bool met() const;
};

/// Lines for a terminal: one a figure, in columns.
std::string figures_text(const Outcome& outcome);

/// A table in Markdown: case, figure, value, target, verdict.
std::string table_md(const std::vector<Outcome>& outcomes);

/// The same as CSV with the numbers in full: case, figure, value, unit, low, high, verdict. An open end is empty.
std::string table_csv(const std::vector<Outcome>& outcomes);

/// As in "21 figures: 17 met, 2 missed, 2 without a target".
std::string count_text(const std::vector<Outcome>& outcomes);

}  // namespace seiche::apps::validate
