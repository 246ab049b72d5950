#include "render/picture/polyline.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

constexpr double slack = time_slack;

// The least and the greatest point of the one column that is being gone through, in the order in which they came.
class Column {
 public:
  bool holds(long number) const { return !empty_ && number == number_; }

  void add(const Point& point, long number) {
    if (empty_) low_ = high_ = point;
    if (point[1] < low_[1]) low_ = point;
    if (point[1] > high_[1]) high_ = point;
    number_ = number;
    empty_ = false;
  }

  void flush(Line& line) {
    if (empty_) return;
    const bool rising = low_[0] < high_[0];
    for (const Point& point : {rising ? low_ : high_, rising ? high_ : low_})
      if (line.empty() || line.back() != point) line.push_back(point);
    empty_ = true;
  }

 private:
  Point low_{}, high_{};
  long number_ = 0;
  bool empty_ = true;
};

}  // namespace

std::vector<Line> thinned(const Series& series, double until, double column) {
  std::vector<Line> lines;
  Line line;
  Column now;
  Point last{};
  const auto finish = [&] {
    now.flush(line);
    if (!line.empty() && line.back() != last) line.push_back(last);
    if (!line.empty()) lines.push_back(std::move(line));
    line.clear();
  };
  for (std::size_t i = 0; i < series.time.size() && series.time[i] <= until * (1 + slack); ++i) {
    const Point point{series.time[i], series.value[i]};
    if (point[0] < 0) continue;
    if (!std::isfinite(point[1])) {
      finish();
      continue;
    }
    const long number = static_cast<long>(point[0] / column);
    if (line.empty() && !now.holds(number)) line.push_back(point);
    if (!now.holds(number)) now.flush(line);
    now.add(point, number);
    last = point;
  }
  finish();
  return lines;
}

std::vector<Line> clipped(const Line& line, Range heights) {
  std::vector<Line> parts;
  const auto inside = [&](const Point& p) { return p[1] >= heights.low && p[1] <= heights.high; };
  // Where the piece from `a` crosses the height that `out` lies beyond.
  const auto edge = [&](const Point& a, const Point& b, const Point& out) -> Point {
    const double height = out[1] > heights.high ? heights.high : heights.low;
    return {a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]), height};
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Point &b = line[i], &a = line[i > 0 ? i - 1 : 0];
    const bool passes = (a[1] < heights.low && b[1] > heights.high) || (a[1] > heights.high && b[1] < heights.low);
    if (i == 0 && inside(b)) parts.emplace_back();
    if (!inside(a) && (inside(b) || passes)) parts.push_back({edge(a, b, a)});
    if (inside(b)) parts.back().push_back(b);
    if (!inside(b) && (inside(a) || passes)) parts.back().push_back(edge(a, b, b));
  }
  return parts;
}

std::vector<Line> dashed(const Line& line, double dash, double gap) {
  std::vector<Line> dashes;
  double along = 0;  // since the current dash began
  const auto begin = [&](const Point& point) { dashes.push_back({point}); };
  if (!line.empty()) begin(line.front());
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    const double length = std::hypot(b[0] - a[0], b[1] - a[1]);
    const auto at = [&](double done) -> Point {
      return {a[0] + (b[0] - a[0]) * done / length, a[1] + (b[1] - a[1]) * done / length};
    };
    double done = 0;
    while (done < length) {
      const bool drawing = along < dash;
      const double step = std::min((drawing ? dash : dash + gap) - along, length - done);
      done += step;
      along += step;
      if (drawing) dashes.back().push_back(at(done));
      // Both ends of an interval are set to exact numbers, so that no step is lost to rounding.
      if (drawing && along >= dash - slack * dash) along = dash;
      if (!drawing && along >= dash + gap - slack * dash) {
        along = 0;
        begin(at(done));
      }
    }
  }
  std::erase_if(dashes, [](const Line& one) { return one.size() < 2; });
  return dashes;
}

}  // namespace seiche::render
