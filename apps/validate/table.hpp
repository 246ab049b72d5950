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

  /// Nothing is wrong with it but known misses.
  bool passed() const;
};

/// Lines for a terminal: one a figure, in columns.
std::string figures_text(const Outcome& outcome);

/// A table in Markdown: case, figure, value, target, verdict; of a known miss also its reason.
std::string table_md(const std::vector<Outcome>& outcomes);

/// The same as CSV with the numbers in full: case, figure, value, unit, low, high, verdict, reason of a known miss. An
/// open end is empty.
std::string table_csv(const std::vector<Outcome>& outcomes);

/// As in "21 figures: 16 met, 2 missed, 1 known miss, 2 without a target".
std::string count_text(const std::vector<Outcome>& outcomes);

}  // namespace seiche::apps::validate
