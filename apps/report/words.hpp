#pragma once
#include <functional>
#include <string>

#include "apps/report/contents.hpp"

namespace seiche::apps::report {

/// As in "5 mm", "0.6 m", their space one that doesn't break.
std::string length_text(double metres);

/// The liquid, its tank and how it moves, in one sentence that holds for all runs: a number that varies is told as its
/// range, as in "by 5 to 20 mm", and a motion that varies in more than its numbers as varying.
std::string tank_sentence(const Report& report);

/// How a run ended.
struct Outcome {
  std::string what;    ///< survived | stopped | interrupted | unfinished, which is a run that goes on or was killed
  std::string time;    ///< as in "at 0.229 s"
  std::string reason;  ///< of a run that stopped
};
Outcome outcome_of(const ReportRun& run);

/// As in "survived 3 s", "stopped at 0.229 s: 61 of 1200 fluid particles leaked".
std::string outcome_text(const ReportRun& run);

/// What `text` says of each run, each said once, parted by commas.
std::string of_all(const Report& report, const std::function<std::string(const ReportRun&)>& text);

}  // namespace seiche::apps::report
