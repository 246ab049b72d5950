#pragma once
#include <cstddef>
#include <string>

namespace seiche::apps {

/// How far a run, or a replay of one, has come.
struct Moment {
  double time = 0, end = 0;    ///< simulated [s]
  long frame = 0, frames = 0;  ///< number of the one worked on, and of the run's last
  long steps = 0;
  double elapsed = 0;             ///< wall-clock [s]
  bool stopping = false;          ///< a signal came; the run ends with the current frame
  double start = 0;               ///< simulated time that it began at [s]
  const char* counted = "steps";  ///< what `steps` are
};

/// As in "1:05" or "2:03:04".
std::string clock_text(double seconds);

/// For a terminal `columns` wide.
std::string progress_bar(const Moment& moment, int columns);

/// For a log.
std::string progress_line(const Moment& moment);

/// Of the outputs, after the last step, while `frames` wait for them.
std::string rest_line(std::size_t frames);

/// Shows a run's progress on standard output: a bar that moves on a terminal, else a line at every 5 %.
class Progress {
 public:
  enum class Style { none, bar, lines };
  static constexpr double bar_interval = 0.1;  ///< between two drawings [s]

  explicit Progress(Style style) : style_(style) {}

  /// The style that suits standard output.
  static Style suitable(bool quiet);

  void show(const Moment& moment);

  /// The steps are done, the outputs not: `frames` wait for them. @param lasted since the last step [s]
  void show_rest(std::size_t frames, double lasted);

  /// Takes the bar away, so that something else can be printed.
  void clear();

 private:
  Style style_;
  double next_ = 0;  // bar: wall-clock time of the next drawing [s]; lines: share of the run at the next line
  bool told_stopping_ = false, told_rest_ = false;
};

}  // namespace seiche::apps
