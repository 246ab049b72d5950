#include "render/curves/curve_panel.hpp"

#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>

#include "render/curves/curve_key.hpp"
#include "render/picture/curve_layout.hpp"
#include "render/picture/range.hpp"

namespace seiche::render {
namespace {

constexpr double column = 1;  // of time that one pixel shows; finer detail can't be seen

double widest(const Ticks& ticks) {
  double width = 0;
  for (const double value : ticks.values) width = std::max(width, text_width(tick_label(value, ticks.step)));
  return width;
}

// As many as stand apart.
Ticks time_ticks(double end, double room) {
  int most = most_ticks;
  const auto fit = [&](const Ticks& ticks) { return most * (widest(ticks) + 1) < room; };
  while (most > fewest_ticks && !fit(round_ticks({0, end}, most))) --most;
  return round_ticks({0, end}, most);
}

int most_values(double room) { return std::clamp(static_cast<int>(room / 1.5), fewest_ticks, most_ticks); }

double middle(const Box& box) { return box.y + box.height / 2; }

}  // namespace

CurvePanel::CurvePanel(vtkRenderer* renderer, const CurvePlace& place, double font, const SensorCurve& curve,
                       const Palette& colours)
    : place_(place),
      font_(curve_font * font),
      thin_(std::max(1.0, std::round(font / 20))),
      curve_(curve),
      colours_(colours),
      axes_(renderer),
      line_(renderer),
      references_(renderer),
      mark_(renderer) {}

Point CurvePanel::at(const Point& point) const {
  const double along = point[0] / curve_.end, up = (point[1] - range_->low) / (range_->high - range_->low);
  return {place_.plot.x + along * place_.plot.width, place_.plot.y + up * place_.plot.height};
}

Line CurvePanel::at(Line line) const {
  for (Point& point : line) point = at(point);
  return line;
}

void CurvePanel::draw_values() {
  const Box& plot = place_.plot;
  const Ticks ticks = round_ticks(*range_, most_values(plot.height / font_));
  for (const double value : ticks.values) {
    const double y = at({0, value})[1];
    axes_.box({plot.x, y - thin_ / 2, plot.width, thin_}, colours_.grid);
    axes_.text(tick_label(value, ticks.step), place_.values.right(), y, font_, Align::right, colours_.ink);
  }
}

void CurvePanel::draw_times() {
  const Box& plot = place_.plot;
  const double y = middle(place_.times);
  const Ticks ticks = time_ticks(curve_.end, plot.width / font_);
  for (const double time : ticks.values) {
    const double x = at({time, 0})[0];
    axes_.box({x - thin_ / 2, plot.y - 0.3 * font_, thin_, 0.3 * font_}, colours_.ink);
    axes_.text(tick_label(time, ticks.step), x, y, font_, Align::centre, colours_.ink);
  }
  const double before = text_width(tick_label(0, ticks.step)) / 2 + name_gap;
  axes_.text(time_title, plot.x - before * font_, y, font_, Align::right, colours_.ink);
}

void CurvePanel::draw_axes() {
  const Box& plot = place_.plot;
  axes_.clear();
  draw_values();
  draw_times();
  axes_.box({plot.x - thin_ / 2, plot.y - thin_ / 2, thin_, plot.height + thin_}, colours_.ink);
  axes_.box({plot.x - thin_ / 2, plot.y - thin_ / 2, plot.width + thin_, thin_}, colours_.ink);
  place_title(axes_, curve_, place_.title, font_, colours_);
  place_key(axes_, curve_, place_.key, font_, colours_);
}

void CurvePanel::draw_references() {
  references_.clear();
  for (std::size_t i = 0; i < curve_.references.size(); ++i) {
    const auto [dash, gap] = dashes_of(i);
    const Rgb colour = colours_.references[i % colours_.references.size()];
    const auto lines = thinned(curve_.references[i].series, curve_.end, column * curve_.end / place_.plot.width);
    for (const Line& line : lines)
      for (const Line& one : dashed(at(line), dash * font_, gap * font_))
        references_.line(one, reference_width * font_, colour);
  }
}

void CurvePanel::show(double time) {
  const Box& plot = place_.plot;
  const Range range = axis_range(curve_);
  if (!range_ || range_->low != range.low || range_->high != range.high) {
    range_ = range;
    draw_axes();
    draw_references();
  }
  line_.clear();
  mark_.clear();
  mark_.box({at({time, 0})[0] - thin_ / 2, plot.y, thin_, plot.height}, colours_.ink);
  for (const Trace& trace : curve_.traces) draw_trace(trace, time);
}

void CurvePanel::draw_trace(const Trace& trace, double time) {
  for (const Line& line : thinned(trace.series, time, column * curve_.end / place_.plot.width))
    for (const Line& part : clipped(line, *range_)) line_.line(at(part), curve_width * font_, trace.colour);
  const auto reading = latest(trace, time);
  if (!reading) return;
  const auto [x, y] = at({(*reading)[0], std::clamp((*reading)[1], range_->low, range_->high)});
  if (trace.broken_off && trace.series.time.back() < time * (1 - time_slack))
    mark_.cross(x, y, 0.4 * font_, curve_width * font_, trace.colour);
  else
    mark_.ring(x, y, 0, 0.3 * font_, trace.colour);
}

}  // namespace seiche::render
