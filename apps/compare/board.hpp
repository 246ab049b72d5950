#pragma once
#include <string>
#include <vector>

#include "apps/common/progress.hpp"

namespace seiche::apps::compare {

/// How far one of several runs has come.
struct Lane {
  enum class State { waiting, running, over };
  std::string label;
  State state = State::waiting;
  double time = 0, end = 0;            ///< how far it is, and where it ends
  std::string form = "{:.2f}/{:g} s";  ///< how these two are told
  std::string verdict;                 ///< once it is over
};

/// Of a lane: 1 once it is over.
double share(const Lane& lane);

/// As in "KF3   [####------]  41 %  4.10/10 s"; `width`: of the labels' column.
std::string lane_line(const Lane& lane, std::size_t width);

/// As in "total [###-------]  31 %  2 of 5 done, 1:23 so far".
std::string total_line(const std::vector<Lane>& lanes, std::size_t width, double elapsed);

/// Shows how several runs come along, on standard output: on a terminal a line each and, of several, a total, drawn
/// anew in place; else a line for each tenth of a run, and for its end.
class Board {
 public:
  explicit Board(Progress::Style style) : style_(style) {}

  /// `elapsed`: wall-clock time since the first began [s].
  void show(const std::vector<Lane>& lanes, double elapsed);

  /// Another line, below what is there.
  void say(const std::string& line);

 private:
  void redraw(const std::vector<Lane>& lanes, double elapsed);
  void log(const std::vector<Lane>& lanes, double elapsed);

  Progress::Style style_;
  std::size_t drawn_ = 0;     // lines on the terminal
  std::vector<double> told_;  // log: share of each lane that has been told; above 1 once its end is
};

}  // namespace seiche::apps::compare
