#include "render/curves/curve_panel.hpp"

#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>

#include "render/curves/curve_key.hpp"
#include "render/picture/curve_layout.hpp"

namespace seiche::render {
namespace {

constexpr double column = 1;  // of time that one pixel shows; finer detail can't be seen

// With as many ticks as stand apart.
Axis time_axis(double end, double room) {
  int most = most_ticks;
  Axis axis = axis_of({0, end}, most);
  while (most > fewest_ticks && most * (label_width(axis) + 1) >= room) axis = axis_of({0, end}, --most);
  return axis;
}

int most_values(double room) { return std::clamp(static_cast<int>(room / 1.5), fewest_ticks, most_ticks); }

double middle(const Box& box) { return box.y + box.height / 2; }

}  // namespace

CurvePanel::CurvePanel(vtkRenderer* renderer, const CurveBoxes& place, double font, const SensorCurve& curve,
                       const Palette& colours)
    : boxes_(place),
      font_(curve_font * font),
      thin_(std::max(1.0, std::round(font / 20))),
      curve_(curve),
      colours_(colours),
      axes_(renderer),
      line_(renderer),
      references_(renderer),
      mark_(renderer),
      times_(time_axis(curve.end, place.plot.width / font_)) {}

Point CurvePanel::at(const Point& point) const {
  const Box& plot = boxes_.plot;
  return {plot.x + times_.along(point[0]) * plot.width, plot.y + values_->along(point[1]) * plot.height};
}

Line CurvePanel::at(Line line) const {
  for (Point& point : line) point = at(point);
  return line;
}

void CurvePanel::draw_values() {
  const Box& plot = boxes_.plot;
  for (const Tick& tick : values_->ticks) {
    const double y = at({0, tick.position})[1];
    axes_.box({plot.x, y - thin_ / 2, plot.width, thin_}, colours_.grid);
    axes_.text(tick.label, boxes_.values.right(), y, font_, Align::right, colours_.foreground);
  }
}

void CurvePanel::draw_times() {
  const Box& plot = boxes_.plot;
  const double y = middle(boxes_.times);
  for (const Tick& tick : times_.ticks) {
    const double x = at({tick.position, 0})[0];
    axes_.box({x - thin_ / 2, plot.y - 0.3 * font_, thin_, 0.3 * font_}, colours_.foreground);
    axes_.text(tick.label, x, y, font_, Align::centre, colours_.foreground);
  }
  const double before = text_width(times_.ticks.front().label) / 2 + name_gap;
  axes_.text(time_title, plot.x - before * font_, y, font_, Align::right, colours_.foreground);
}

void CurvePanel::draw_axes() {
  const Box& plot = boxes_.plot;
  axes_.clear();
  draw_values();
  draw_times();
  axes_.box({plot.x - thin_ / 2, plot.y - thin_ / 2, thin_, plot.height + thin_}, colours_.foreground);
  axes_.box({plot.x - thin_ / 2, plot.y - thin_ / 2, plot.width + thin_, thin_}, colours_.foreground);
  place_title(axes_, curve_, boxes_.title, font_, colours_);
  place_key(axes_, curve_, boxes_.key, font_, colours_);
}

void CurvePanel::draw_references() {
  references_.clear();
  for (std::size_t i = 0; i < curve_.references.size(); ++i) {
    const auto [dash, gap] = dashes_of(i);
    const Rgb colour = colours_.references[i % colours_.references.size()];
    const auto lines = thinned(curve_.references[i].series, curve_.end, column * curve_.end / boxes_.plot.width);
    for (const Line& line : lines)
      for (const Line& one : dashed(at(line), dash * font_, gap * font_))
        references_.line(one, reference_width * font_, colour);
  }
}

void CurvePanel::show(double time) {
  const Box& plot = boxes_.plot;
  const Range range = axis_range(curve_);
  if (!values_ || values_->range.low != range.low || values_->range.high != range.high) {
    values_ = axis_of(range, most_values(plot.height / font_));
    draw_axes();
    draw_references();
  }
  line_.clear();
  mark_.clear();
  mark_.box({at({time, 0})[0] - thin_ / 2, plot.y, thin_, plot.height}, colours_.foreground);
  for (const Trace& trace : curve_.traces) draw_trace(trace, time);
}

void CurvePanel::draw_trace(const Trace& trace, double time) {
  for (const Line& line : thinned(trace.series, time, column * curve_.end / boxes_.plot.width))
    for (const Line& part : clipped(line, values_->range)) line_.line(at(part), curve_width * font_, trace.colour);
  const auto reading = latest(trace, time);
  if (!reading) return;
  const auto [x, y] = at({(*reading)[0], std::clamp((*reading)[1], values_->range.low, values_->range.high)});
  if (trace.broken_off && trace.series.time.back() < time * (1 - time_slack))
    mark_.cross(x, y, 0.4 * font_, curve_width * font_, trace.colour);
  else
    mark_.ring(x, y, 0, 0.3 * font_, trace.colour);
}

}  // namespace seiche::render
