#pragma once
#include <string>
#include <vector>

#include "apps/common/progress.hpp"

namespace seiche::apps::compare {

/// How far one of several runs has come.
struct ProgressRow {
  enum class State { waiting, running, over };
  std::string label;
  State state = State::waiting;
  double time = 0, end = 0;              ///< how far it is, and where it ends
  std::string format = "{:.2f}/{:g} s";  ///< of these two
  std::string ending;                    ///< once it is over
};

/// Of a row: 1 once it is over.
double share(const ProgressRow& row);

/// As in "KF3   [####------]  41 %  4.10/10 s"; `width`: of the labels' column.
std::string row_line(const ProgressRow& row, std::size_t width);

/// As in "total [###-------]  31 %  2 of 5 done, 1:23 so far".
std::string total_line(const std::vector<ProgressRow>& rows, std::size_t width, double elapsed);

/// Shows how several runs come along, on standard output: on a terminal a line each and, of several, a total, drawn
/// anew in place; else a line for each tenth of a run, and for its end.
class ProgressTable {
 public:
  explicit ProgressTable(Progress::Style style) : style_(style) {}

  /// `elapsed`: wall-clock time since the first began [s].
  void show(const std::vector<ProgressRow>& rows, double elapsed);

  /// Another line, below what is there.
  void say(const std::string& line);

 private:
  void redraw(const std::vector<ProgressRow>& rows, double elapsed);
  void log(const std::vector<ProgressRow>& rows, double elapsed);

  Progress::Style style_;
  std::size_t drawn_ = 0;       // lines on the terminal
  std::vector<double> logged_;  // log: share of each row when it was last logged; above 1 once its end is
};

}  // namespace seiche::apps::compare
