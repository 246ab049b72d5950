#include "apps/compare/progress_table.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace seiche::apps::compare {
namespace {

constexpr const char* total = "total";

std::string bar(double share) {
  constexpr int width = 10;
  return fmt::format("[{:-<{}}] {:3.0f} %", std::string(static_cast<std::size_t>(width * share), '#'), width,
                     std::floor(100 * share + 1e-9));
}

double share(const std::vector<ProgressRow>& rows) {
  double sum = 0;
  for (const ProgressRow& row : rows) sum += share(row);
  return rows.empty() ? 1 : sum / static_cast<double>(rows.size());
}

std::size_t label_width(const std::vector<ProgressRow>& rows) {
  std::size_t width = std::char_traits<char>::length(total);
  for (const ProgressRow& row : rows) width = std::max(width, row.label.size());
  return width;
}

std::string cut(const std::string& line) {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::size_t room = (known ? size.ws_col : 80u) - 1u;  // a line that wraps can't be drawn over
  return line.size() <= room ? line : line.substr(0, room - 3) + "...";
}

}  // namespace

double share(const ProgressRow& row) {
  if (row.state == ProgressRow::State::over) return 1;
  return row.end > 0 ? std::min(1.0, row.time / row.end) : 0;
}

std::string row_line(const ProgressRow& row, std::size_t width) {
  const auto line = [&](const std::string& what) { return fmt::format("{:<{}}  {}", row.label, width, what); };
  if (row.state == ProgressRow::State::waiting) return line("waiting");
  if (row.state == ProgressRow::State::over) return line(row.ending);
  return line(bar(share(row)) + "  " + fmt::format(fmt::runtime(row.format), row.time, row.end));
}

std::string total_line(const std::vector<ProgressRow>& rows, std::size_t width, double elapsed) {
  const auto done = std::count_if(rows.begin(), rows.end(),
                                  [](const ProgressRow& row) { return row.state == ProgressRow::State::over; });
  return fmt::format("{:<{}}  {}  {} of {} done, {} so far", total, width, bar(share(rows)), done, rows.size(),
                     clock_text(elapsed));
}

void ProgressTable::show(const std::vector<ProgressRow>& rows, double elapsed) {
  if (style_ == Progress::Style::bar) redraw(rows, elapsed);
  if (style_ == Progress::Style::lines) log(rows, elapsed);
  std::fflush(stdout);
}

void ProgressTable::say(const std::string& line) {
  if (style_ == Progress::Style::none) return;
  fmt::print("{}\n", line);
  std::fflush(stdout);
  drawn_ = 0;
}

void ProgressTable::redraw(const std::vector<ProgressRow>& rows, double elapsed) {
  const std::size_t width = label_width(rows);
  if (drawn_ > 0) fmt::print("\033[{}A", drawn_);
  for (const ProgressRow& row : rows) fmt::print("\r\033[K{}\n", cut(row_line(row, width)));
  if (rows.size() > 1) fmt::print("\r\033[K{}\n", cut(total_line(rows, width, elapsed)));
  drawn_ = rows.size() + (rows.size() > 1 ? 1 : 0);
}

void ProgressTable::log(const std::vector<ProgressRow>& rows, double elapsed) {
  constexpr double step = 0.1, after_end = 2;
  logged_.resize(rows.size(), 0);
  const std::size_t width = label_width(rows);
  bool news = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool over = rows[i].state == ProgressRow::State::over;
    const double reached = over ? after_end : step * std::floor(share(rows[i]) / step + 1e-9);
    if (reached <= logged_[i]) continue;
    logged_[i] = reached;
    fmt::print("{}\n", row_line(rows[i], width));
    news = news || over;
  }
  if (news && rows.size() > 1) fmt::print("{}\n", total_line(rows, width, elapsed));
}

}  // namespace seiche::apps::compare
