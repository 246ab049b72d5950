#include "apps/report/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>
#include <sstream>

#include "apps/report/assets.hpp"
#include "apps/report/chart.hpp"
#include "apps/report/html.hpp"
#include "apps/report/stage.hpp"
#include "apps/report/table.hpp"
#include "apps/report/template.hpp"
#include "apps/report/words.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/variants.hpp"

namespace seiche::apps::report {
namespace {

std::string facts_html(const Report& report) {
  std::string html = "<dl class=\"facts\">\n";
  const auto fact = [&](const char* name, const std::string& value) {
    if (!value.empty()) html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, escaped(value));
  };
  const auto all = [&](auto text) { return of_all(report, text); };
  fact("Preset", all([](const ReportRun& run) { return run.run.info.preset; }));
  fact("Kernel", all([](const ReportRun& run) { return run.run.info.kernel; }));
  fact("Spacing", all([](const ReportRun& run) { return length_text(run.run.info.spacing); }));
  fact("Liquid particles", all([](const ReportRun& run) {
         const Statistics& s = run.run.record.statistics;
         const long count = s.fluid_particles + s.leaked + s.spilled;
         return count > 0 ? fmt::format(std::locale(), "{}", count) : std::string();
       }));
  fact("Duration", all([](const ReportRun& run) { return fmt::format("{:g} s", run.run.info.end); }));
  fact("Program", "Seiche " + all([](const ReportRun& run) { return run.run.info.version; }));
  return html + "</dl>\n";
}

std::string outcomes_html(const Report& report) {
  std::string html = "<ul class=\"outcomes\">\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ReportRun& run = report.runs[i];
    const bool alone = report.runs.size() == 1;
    html += fmt::format("<li>{}{}{}</li>\n", alone ? "" : line_sample(run_line(i)),
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
      html += fmt::format("<li><button type=\"button\" aria-pressed=\"true\" data-run=\"{}\">{}{}</button></li>",
                          run_line(i).name, line_sample(run_line(i)), escaped(report.runs[i].label));
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
      "<details>\n<summary>{} <span>scene hash</span> <code>{}</code></summary>\n<pre>{}</pre>\n</details>\n",
      alone ? "All parameters" : "<b>" + escaped(run.label) + "</b>", escaped(run.run.info.scene_hash), text);
}

// As in "method.kernel = KF1, KF3", each value once.
std::vector<std::string> varied(const Report& report) {
  std::vector<const Scene*> scenes;
  for (const ReportRun& run : report.runs) scenes.push_back(&run.run.scene);
  std::vector<std::string> all;
  for (const Option* option : differences(scenes))
    all.push_back(fmt::format("{} = {}", dotted(*option), of_all(report, [&](const ReportRun& run) {
                                return text_of(value_of(*option, run.run.scene));
                              })));
  return all;
}

// Its lines end between words.
std::string command_html(const std::string& command) {
  std::string html;
  std::istringstream words(command);
  for (std::string word; words >> word;)
    html += fmt::format("{}<span>{}</span>", html.empty() ? "" : " ", escaped(word));
  return fmt::format("<code class=\"command\">{}</code>", html);
}

// The scene, what varied and how to do it again, then each run's parameters with the scene's hash.
std::string what_was_run_html(const Report& report) {
  const bool alone = report.runs.size() == 1;
  std::string html = "<section class=\"origin\">\n<h2>What was run</h2>\n<dl>\n";
  const auto fact = [&](const char* name, const std::string& value) {
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escaped(value));
  };
  if (!report.command.empty()) html += "<dt>Command</dt><dd>" + command_html(report.command) + "</dd>\n";
  fact("Scene", of_all(report, [](const ReportRun& run) { return run.run.scene.file; }));
  if (const auto keys = varied(report); !keys.empty()) fact("Varied", fmt::format("{}", fmt::join(keys, "; ")));
  html += fmt::format(
      "</dl>\n<p>All parameters{} are a whole scene, to be run again when saved beside the scene’s own file.{}</p>\n",
      alone ? "" : " of a run", alone ? "" : " What differs from the first run is marked.");
  std::set<std::string> first;
  std::istringstream lines(report.runs.front().run.info.parameters);
  for (std::string line; std::getline(lines, line);) first.insert(line);
  for (const ReportRun& run : report.runs) html += parameters_html(run, first, alone);
  return html + "</section>\n";
}

}  // namespace

std::string page(const Report& report, const std::filesystem::path& folder) {
  return filled(skeleton, {{"version", escaped(version())},
                           {"title", escaped(report.title)},
                           {"style", style},
                           {"script", script},
                           {"layout", report.runs.size() == 1 ? "alone" : "several"},
                           {"end", fmt::format("{:.6g}", reached(report))},
                           {"interval", fmt::format("{:.6g}", 1 / report.runs.front().run.scene.output.frame_rate)},
                           {"tank", escaped(tank_sentence(report))},
                           {"outcomes", outcomes_html(report)},
                           {"facts", facts_html(report)},
                           {"stage", stage_html(report, folder)},
                           {"curves", curves_html(report)},
                           {"measures", table_html(report)},
                           {"origin", what_was_run_html(report)}});
}

}  // namespace seiche::apps::report
