#include "apps/common/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace seiche::apps {
namespace {

constexpr double line_share = 0.05;
constexpr double patience = 1;  // a rest that lasts longer gets a line in a log [s]

double share(const Moment& m) { return m.end > m.start ? (m.time - m.start) / (m.end - m.start) : 1; }

std::string remaining(const Moment& m) {
  if (m.stopping) return "ending with this frame (Ctrl-C: at once)";
  if (share(m) < 0.01) return "";  // Too early to tell.
  return clock_text(m.elapsed * (1 / share(m) - 1)) + " left";
}

std::string facts(const Moment& m) {
  const double rate = m.elapsed > 0 ? static_cast<double>(m.steps) / m.elapsed : 0;
  return fmt::format("{:3.0f} %  {:.2f}/{:g} s  frame {}/{}  {} {}  {:.3g} {}/s  {}", std::floor(100 * share(m)),
                     m.time, m.end, m.frame, m.frames, m.steps, m.counted, rate, m.counted, remaining(m));
}

int terminal_columns() {
  winsize size{};
  return ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

void print(const std::string& text) {
  std::fputs(text.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace

std::string clock_text(double seconds) {
  const long s = std::lround(seconds), minutes = s / 60, hours = minutes / 60;
  return hours > 0 ? fmt::format("{}:{:02}:{:02}", hours, minutes % 60, s % 60)
                   : fmt::format("{}:{:02}", minutes, s % 60);
}

std::string progress_bar(const Moment& moment, int columns) {
  constexpr int width = 10;
  const int full = static_cast<int>(width * share(moment));
  const std::string bar = fmt::format("[{:-<{}}] {}", std::string(full, '#'), width, facts(moment));
  return bar.substr(0, std::max(columns - 1, 0));  // A line that wraps can't be drawn over.
}

std::string progress_line(const Moment& moment) { return facts(moment); }

std::string rest_line(std::size_t frames) {
  if (frames == 0) return "steps done; finishing the outputs";
  return fmt::format("steps done; {} frame{} to draw and write", frames, frames == 1 ? "" : "s");
}

Progress::Style Progress::suitable(bool quiet) {
  if (quiet) return Style::none;
  return isatty(STDOUT_FILENO) ? Style::bar : Style::lines;
}

void Progress::show(const Moment& moment) {
  const bool news = moment.stopping && !told_stopping_;
  told_stopping_ = moment.stopping;
  if (style_ == Style::bar && (news || moment.elapsed >= next_)) {
    print("\r\033[K" + progress_bar(moment, terminal_columns()));
    next_ = moment.elapsed + bar_interval;
  }
  if (style_ == Style::lines && (news || share(moment) >= next_)) {
    print(progress_line(moment) + "\n");
    next_ = line_share * (std::floor(share(moment) / line_share + 1e-9) + 1);
  }
}

void Progress::show_rest(std::size_t frames, double lasted) {
  if (style_ == Style::bar) print("\r\033[K" + rest_line(frames).substr(0, std::max(terminal_columns() - 1, 0)));
  if (style_ == Style::lines && !told_rest_ && lasted >= patience) {
    print(rest_line(frames) + "\n");
    told_rest_ = true;
  }
}

void Progress::clear() {
  if (style_ == Style::bar) print("\r\033[K");
}

}  // namespace seiche::apps
