#include "apps/compare/board.hpp"

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

double share(const std::vector<Lane>& lanes) {
  double sum = 0;
  for (const Lane& lane : lanes) sum += share(lane);
  return lanes.empty() ? 1 : sum / static_cast<double>(lanes.size());
}

std::size_t label_width(const std::vector<Lane>& lanes) {
  std::size_t width = std::char_traits<char>::length(total);
  for (const Lane& lane : lanes) width = std::max(width, lane.label.size());
  return width;
}

std::string cut(const std::string& line) {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const std::size_t room = (known ? size.ws_col : 80u) - 1u;  // a line that wraps can't be drawn over
  return line.size() <= room ? line : line.substr(0, room - 3) + "...";
}

}  // namespace

double share(const Lane& lane) {
  if (lane.state == Lane::State::over) return 1;
  return lane.end > 0 ? std::min(1.0, lane.time / lane.end) : 0;
}

std::string lane_line(const Lane& lane, std::size_t width) {
  const auto line = [&](const std::string& what) { return fmt::format("{:<{}}  {}", lane.label, width, what); };
  if (lane.state == Lane::State::waiting) return line("waiting");
  if (lane.state == Lane::State::over) return line(lane.verdict);
  return line(bar(share(lane)) + "  " + fmt::format(fmt::runtime(lane.form), lane.time, lane.end));
}

std::string total_line(const std::vector<Lane>& lanes, std::size_t width, double elapsed) {
  const auto done =
      std::count_if(lanes.begin(), lanes.end(), [](const Lane& lane) { return lane.state == Lane::State::over; });
  return fmt::format("{:<{}}  {}  {} of {} done, {} so far", total, width, bar(share(lanes)), done, lanes.size(),
                     clock_text(elapsed));
}

void Board::show(const std::vector<Lane>& lanes, double elapsed) {
  if (style_ == Progress::Style::bar) redraw(lanes, elapsed);
  if (style_ == Progress::Style::lines) log(lanes, elapsed);
  std::fflush(stdout);
}

void Board::say(const std::string& line) {
  if (style_ == Progress::Style::none) return;
  fmt::print("{}\n", line);
  std::fflush(stdout);
  drawn_ = 0;
}

void Board::redraw(const std::vector<Lane>& lanes, double elapsed) {
  const std::size_t width = label_width(lanes);
  if (drawn_ > 0) fmt::print("\033[{}A", drawn_);
  for (const Lane& lane : lanes) fmt::print("\r\033[K{}\n", cut(lane_line(lane, width)));
  if (lanes.size() > 1) fmt::print("\r\033[K{}\n", cut(total_line(lanes, width, elapsed)));
  drawn_ = lanes.size() + (lanes.size() > 1 ? 1 : 0);
}

void Board::log(const std::vector<Lane>& lanes, double elapsed) {
  constexpr double step = 0.1, told_its_end = 2;
  told_.resize(lanes.size(), 0);
  const std::size_t width = label_width(lanes);
  bool news = false;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const bool over = lanes[i].state == Lane::State::over;
    const double reached = over ? told_its_end : step * std::floor(share(lanes[i]) / step + 1e-9);
    if (reached <= told_[i]) continue;
    told_[i] = reached;
    fmt::print("{}\n", lane_line(lanes[i], width));
    news = news || over;
  }
  if (news && lanes.size() > 1) fmt::print("{}\n", total_line(lanes, width, elapsed));
}

}  // namespace seiche::apps::compare
