#include "apps/report/page.hpp"

#include <fmt/format.h>

#include <set>
#include <sstream>

#include "apps/report/assets.hpp"
#include "apps/report/chart.hpp"
#include "apps/report/html.hpp"
#include "apps/report/stage.hpp"
#include "apps/report/table.hpp"
#include "apps/report/words.hpp"
#include "apps/run_info.hpp"

namespace seiche::apps::report {
namespace {

std::string facts_html(const Report& report) {
  std::string html = "<dl class=\"facts\">\n";
  const auto fact = [&](const char* name, const std::string& value) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, escaped(value));
  };
  const auto all = [&](auto text) { return of_all(report, text); };
  fact("Preset", all([](const ReportRun& run) { return run.run.info.preset; }));
  fact("Kernel", all([](const ReportRun& run) { return run.run.info.kernel; }));
  fact("Spacing", all([](const ReportRun& run) { return length_text(run.run.info.spacing); }));
  fact("Liquid particles", all([](const ReportRun& run) {
         const Statistics& s = run.run.record.statistics;
         return fmt::format(std::locale(), "{}", s.fluid_particles + s.leaked + s.spilled);
       }));
  fact("Duration", all([](const ReportRun& run) { return fmt::format("{:g} s", run.run.info.end); }));
  fact("Program", "Seiche " + all([](const ReportRun& run) { return run.run.info.version; }));
  if (report.runs.size() == 1) fact("Scene hash", report.runs.front().run.info.scene_hash);
  return html + "</dl>\n";
}

std::string outcomes_html(const Report& report) {
  std::string html = "<ul class=\"outcomes\">\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ReportRun& run = report.runs[i];
    const bool alone = report.runs.size() == 1;
    html += fmt::format("<li>{}{}{}</li>\n", alone ? "" : line_sample(fmt::format("v{}", i)),
                        alone ? "" : fmt::format("<b>{}</b> ", escaped(run.label)), escaped(outcome_text(run)));
  }
  return html + "</ul>\n";
}

std::string curves_html(const Report& report) {
  const std::vector<Chart> charts = charts_of(report);
  if (charts.empty()) return "";
  const bool alone = report.runs.size() == 1;
  std::string html = "<section>\n<h2>Curves</h2>\n";
  if (!alone) {
    html += "<ul class=\"key runs\" aria-label=\"Runs, to be shown or hidden\">";
    for (std::size_t i = 0; i < report.runs.size(); ++i)
      html += fmt::format("<li><button type=\"button\" aria-pressed=\"true\" data-run=\"v{}\">{}{}</button></li>", i,
                          line_sample(fmt::format("v{}", i)), escaped(report.runs[i].label));
    html += "</ul>\n";
  }
  for (const Chart& chart : charts) html += chart_html(chart, alone);
  return html + "</section>\n";
}

// A run's parameters; those lines are marked that the first run's don't have.
std::string parameters_html(const ReportRun& run, const std::set<std::string>& first, bool alone) {
  std::string text;
  std::istringstream lines(run.run.info.parameters);
  for (std::string line; std::getline(lines, line);) {
    const std::string html = escaped(line);
    text += (first.contains(line) ? html : fmt::format("<mark>{}</mark>", html)) + "\n";
  }
  return fmt::format(
      "<details>\n<summary>All parameters{}</summary>\n<p>Scene {}, hash {}</p>\n<pre>{}</pre>\n</details>\n",
      alone ? "" : " of " + escaped(run.label), escaped(run.run.scene.file), escaped(run.run.info.scene_hash), text);
}

std::string all_parameters_html(const Report& report) {
  std::set<std::string> first;
  std::istringstream lines(report.runs.front().run.info.parameters);
  for (std::string line; std::getline(lines, line);) first.insert(line);
  std::string html = "<section class=\"parameters\">\n<h2>Parameters</h2>\n";
  for (const ReportRun& run : report.runs) html += parameters_html(run, first, report.runs.size() == 1);
  return html + "</section>\n";
}

}  // namespace

std::string page(const Report& report, const std::filesystem::path& folder) {
  const Scene& scene = report.runs.front().run.scene;
  const std::string title = escaped(report.title);
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<meta name=\"generator\" content=\"Seiche {}\">\n"
      "<title>{} · Seiche</title>\n<style>\n{}</style>\n</head>\n<body>\n"
      "<main class=\"{}\" data-end=\"{:.6g}\" data-interval=\"{:.6g}\">\n",
      escaped(version()), title, style, report.runs.size() == 1 ? "alone" : "several", reached(report),
      1 / scene.output.frame_rate);
  html += fmt::format("<header>\n<h1>{}</h1>\n<p class=\"tank\">{}</p>\n{}{}</header>\n", title,
                      escaped(tank_sentence(scene)), outcomes_html(report), facts_html(report));
  html += stage_html(report, folder) + curves_html(report);
  html += fmt::format("<section>\n<h2>Measures</h2>\n{}</section>\n", table_html(report));
  html += all_parameters_html(report);
  return html + fmt::format("</main>\n<script>\n{}</script>\n</body>\n</html>\n", script);
}

}  // namespace seiche::apps::report
