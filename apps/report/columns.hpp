#pragma once
#include <string>
#include <vector>

#include "apps/report/contents.hpp"
#include "apps/report/measures.hpp"

namespace seiche::apps::report {

/// What one run, or one reference, has in a column: a figure, and what is said below it in small. Empty: nothing known.
struct Cell {
  std::string value, aside;
};

/// A measure of all runs, as text. Columns beside each other with one group stand under one head.
struct Column {
  std::string group;  ///< empty: none
  std::string name, unit;
  std::string note;         ///< what it is, in a sentence; empty: it goes without saying
  std::vector<Cell> cells;  ///< of the runs, then of the references; those may be missing
};

/// How each run ended, its measures and its costs. A column that no run has anything in is left out.
/// @param references of the measured elevation
std::vector<Column> columns_of(const Report& report, const Measured& sensors,
                               const std::vector<render::Reference>& references);

}  // namespace seiche::apps::report
