#include "apps/report/chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "apps/report/html.hpp"
#include "render/curves.hpp"
#include "render/picture.hpp"

namespace seiche::apps::report {
namespace {

std::string classes(const LineStyle& style) {
  return fmt::format("{} {}", style.reference ? "reference" : "run", style.name);
}

constexpr int columns = 750;   // each with two points at most: as fine as a screen shows
constexpr double side = 1000;  // of the square that curves are drawn in before it is stretched
constexpr int time_parts = 10, value_parts = 5;

// Where values stand in the plot, as shares of its width and height, from its upper left corner.
struct Axes {
  double end;
  render::Range range;
  double across(double time) const { return time / end; }
  double down(double value) const { return (range.high - value) / (range.high - range.low); }
};

std::string percent(double share) { return fmt::format("{:.2f}%", 100 * share); }

std::string grid(const Axes& axes) {
  std::string svg;
  const auto out = std::back_inserter(svg);
  for (const auto& [value, label] : render::axis_of(axes.range, value_parts).ticks) {
    const std::string y = percent(axes.down(value));
    fmt::format_to(out, "<line class=\"{}\" x2=\"100%\" y1=\"{}\" y2=\"{}\"/>", value == 0 ? "rest" : "grid", y, y);
    fmt::format_to(out, "<text class=\"value\" x=\"0\" y=\"{}\" dx=\"-8\" dy=\".35em\">{}</text>\n", y, label);
  }
  const render::Axis times = render::axis_of({0, axes.end}, time_parts);
  for (std::size_t i = 0; i < times.ticks.size(); ++i) {
    const std::string x = percent(axes.across(times.ticks[i].position));
    fmt::format_to(out, "<line class=\"tick\" x1=\"{}\" x2=\"{}\" y1=\"100%\" y2=\"100%\"/>", x, x);
    fmt::format_to(out, "<text class=\"time{}\" x=\"{}\" y=\"100%\" dy=\"1.6em\">{}</text>\n", i % 2 == 1 ? " odd" : "",
                   x, times.ticks[i].label);
  }
  svg += "<text class=\"value\" x=\"0\" y=\"100%\" dx=\"-22\" dy=\"1.6em\">t [s]</text>\n";
  return svg;
}

std::string path(const Axes& axes, const Trace& trace) {
  std::string data;
  const auto out = std::back_inserter(data);
  for (const render::Line& line : render::thinned(trace.series, axes.end, axes.end / columns)) {
    char step = 'M';
    for (const auto& [time, value] : line) {
      fmt::format_to(out, "{}{:.1f} {:.1f}", step, side * axes.across(time), side * axes.down(value));
      step = 'L';
    }
  }
  return fmt::format("<path class=\"{}\" d=\"{}\"/>\n", classes(line_style(trace)), data);
}

// Where a run failed.
std::string cross(const Axes& axes, const Trace& trace) {
  return fmt::format("<text class=\"stop {}\" x=\"{}\" y=\"{}\" dy=\".35em\">✕</text>\n", line_style(trace).name,
                     percent(axes.across(trace.series.time.back())),
                     percent(std::clamp(axes.down(trace.series.value.back()), 0.0, 1.0)));
}

std::string key(const Chart& chart, bool alone) {
  const bool compared =
      std::any_of(chart.traces.begin(), chart.traces.end(), [](const Trace& trace) { return trace.reference; });
  std::string html;
  for (const Trace& trace : chart.traces)
    if (trace.reference || (alone && compared))
      html += fmt::format("<li>{}{}</li>", line_sample(line_style(trace)),
                          trace.reference ? escaped(trace.label) : "this run");
  return html.empty() ? html : fmt::format("<ul class=\"key\">{}</ul>", html);
}

// What the curves don't show.
std::string note(const Chart& chart, const Extent& extent) {
  std::string text;
  if (chart.means) text = "Running means; probes.csv has the readings themselves. ";
  if (extent.beyond != 0) {
    text +=
        fmt::format("{} beyond the axis are cut off; the furthest is {:.{}f} {}.", chart.means ? "Means" : "Readings",
                    extent.beyond, std::abs(extent.beyond) < 100 ? 3 : 0, render::raised_powers(chart.column.unit));
  }
  return text.empty() ? text : fmt::format("<p class=\"note\">{}</p>\n", escaped(text));
}

}  // namespace

LineStyle run_line(std::size_t number) { return {fmt::format("v{}", number)}; }

LineStyle reference_line(std::size_t number) { return {fmt::format("r{}", number), true}; }

LineStyle line_style(const Trace& trace) {
  if (trace.of_all) return {"all"};
  return trace.reference ? reference_line(trace.number) : run_line(trace.number);
}

std::string line_sample(const LineStyle& style) {
  return fmt::format(
      "<svg class=\"sample\" aria-hidden=\"true\"><line class=\"{}\" x2=\"100%\" y1=\"50%\" y2=\"50%\"/></svg>",
      classes(style));
}

std::string chart_html(const Chart& chart, bool alone) {
  const Extent extent = extent_of(chart);
  const Axes axes{chart.end, extent.range};
  std::string curves, stops;
  for (const Trace& trace : chart.traces) {
    curves += path(axes, trace);
    if (trace.failed) stops += cross(axes, trace);
  }
  return fmt::format(
      "<figure class=\"chart\">\n<figcaption><b>{0}</b>{1}</figcaption>\n"
      "<svg class=\"plot\" role=\"img\" aria-label=\"{0}, over time from 0 to {2:.4g} s\">\n{3}"
      "<svg class=\"{8}\" viewBox=\"0 0 {4} {4}\" preserveAspectRatio=\"none\" width=\"100%\" "
      "height=\"100%\">\n{5}</svg>\n{6}"
      "<line class=\"mark\" x1=\"0%\" x2=\"0%\" y1=\"0\" y2=\"100%\"/>\n</svg>\n{7}</figure>\n",
      escaped(chart.title), key(chart, alone), chart.end, grid(axes), side, curves, stops, note(chart, extent),
      extent.beyond == 0 ? "whole" : "cut");
}

}  // namespace seiche::apps::report
