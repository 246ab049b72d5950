#include "apps/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "apps/report/chart.hpp"
#include "apps/report/html.hpp"
#include "apps/report/measures.hpp"
#include "apps/report/words.hpp"
#include "render/curve_choice.hpp"

namespace seiche::apps::report {
namespace {

// A line of the table: HTML, but for the note, which is text. An empty cell holds nothing.
struct Row {
  std::string name, unit, note;
  std::vector<std::string> cells;  // of the runs, then of the references; those may be missing
};

template <class F>
std::vector<std::string> cells(const Report& report, F text) {
  std::vector<std::string> result;
  for (const ReportRun& run : report.runs) result.push_back(text(run));
  return result;
}

// "Crest, left 20mm" of "Crest" and "eta_left_20mm".
std::string at_sensor(const std::string& what, const std::string& sensor) {
  const std::string title = render::curve_title(sensor);
  const std::size_t place = title.find(", ");
  return what + (place == std::string::npos ? "" : escaped(title.substr(place)));
}

std::string share_cell(const std::optional<Share>& share, double factor, const char* form) {
  if (!share) return "";
  return fmt::format("{}<small>{:.3g}–{:.3g} s</small>", fmt::format(fmt::runtime(form), factor * share->value),
                     share->from, share->to);
}

// With a true minus sign, which is as long as the plus.
std::string signed_text(double value) { return fmt::format("{}{:.2g}", value < 0 ? "\u2212" : "+", std::abs(value)); }

// Its time doesn't part from its unit where the cell is narrow.
std::string outcome_cell(const ReportRun& run) {
  const std::string outcome = outcome_text(run);
  const std::size_t colon = outcome.find(": ");
  std::string what = outcome.substr(0, colon);
  what.replace(what.rfind(' '), 1, "\u00a0");
  if (colon == std::string::npos) return escaped(what);
  return fmt::format("<strong>{}:</strong> <small class=\"reason\">{}</small>", escaped(what),
                     escaped(outcome.substr(colon + 2)));
}

std::string crest_cell(const std::vector<Crest>& crests, std::size_t number) {
  if (number >= crests.size()) return "";
  return fmt::format("{:.1f}<small>at {:.2f} s</small>", 1000 * crests[number].height, crests[number].time);
}

void add_measures(const Report& report, const std::vector<render::Reference>& references, const Measured& sensors,
                  std::vector<Row>& rows) {
  std::vector<Measures> all;
  for (const ReportRun& run : report.runs) all.push_back(measures_of(run, sensors, references));
  const auto column = [&](auto text) {
    std::vector<std::string> result;
    for (const Measures& one : all) result.push_back(text(one));
    return result;
  };
  rows.push_back(
      {at_sensor("Pressure noise", sensors.pressure), "% of ρgh",
       "Root mean square of what lies above 10 Hz in the pressure, over the weight of the still liquid, ρ g h.",
       column([](const Measures& one) { return share_cell(one.noise, 100, "{:.3g}"); })});
  for (std::size_t i = 0; i < references.size(); ++i)
    rows.push_back(
        {fmt::format("{}, against {}", at_sensor("Elevation error", sensors.elevation), escaped(references[i].label)),
         "–",
         "Root mean square of the difference over that of the reference, over the times that both have: 0 is "
         "perfect, 1 as bad as still liquid.",
         column([&](const Measures& one) { return share_cell(one.errors[i], 1, "{:.3g}"); })});
  const bool compared = !references.empty();
  const std::string note =
      compared
          ? "The highest point within a quarter of a period of a crest of the first reference."
          : "The highest point of a wave between a rise above 1 % of the depth and a fall as far below still level.";
  const double least = least_crest(report.runs.front().run.info);
  const double reach = crest_reach(report.runs.front().run.scene);
  const auto leading = compared ? crests_of(references.front().series, least, most_crests) : std::vector<Crest>();
  for (std::size_t number = 0; number < most_crests; ++number) {
    Row row{at_sensor(fmt::format("Crest {}", number + 1), sensors.elevation), "mm", note,
            column([&](const Measures& one) { return crest_cell(one.crests, number); })};
    for (const render::Reference& reference : references)
      row.cells.push_back(crest_cell(crests_near(reference.series, leading, reach), number));
    rows.push_back(std::move(row));
  }
  rows.push_back(
      {"Level drift", "%", "Mean volume below the surface in the last tenth of the run, less that in the first.",
       column([](const Measures& one) { return one.drift ? signed_text(100 * *one.drift) : std::string(); })});
}

// In initial spacings, so that runs of different resolution compare.
std::string distance_cell(const ReportRun& run) {
  const double least = run.run.record.statistics.least_distance;
  return std::isfinite(least) ? fmt::format("{:.2g}", least / run.run.scene.parameters.particles.spacing) : "";
}

void add_costs(const Report& report, std::vector<Row>& rows) {
  const auto column = [&](auto text) {
    return cells(report, [&](const ReportRun& run) { return text(run.run.record.statistics); });
  };
  rows.push_back({"Particles lost", "", "Liquid particles that leaked through a wall or spilled over the rim.",
                  column([](const Statistics& s) { return fmt::format("{}", s.leaked + s.spilled); })});
  rows.push_back(
      {"Least distance", "l<sub>0</sub>",
       "Of any two particles in any step, in initial spacings: 1 at rest, and the lower, the worse they clump.",
       cells(report, distance_cell)});
  rows.push_back({"Time steps", "", "", column([](const Statistics& s) { return fmt::format("{}", s.steps); })});
  rows.push_back({"Pressure iterations a step", "", "", column([](const Statistics& s) {
                    return s.steps > 0 ? fmt::format("{:.1f}", static_cast<double>(s.iterations) / s.steps)
                                       : std::string();
                  })});
  rows.push_back({"Wall time", "s", "", cells(report, [](const ReportRun& run) {
                    const RunRecord& record = run.run.record;
                    return record.ending ? fmt::format("{:.1f}", record.times.total) : std::string();
                  })});
}

bool is_known(const Row& row) {
  return std::any_of(row.cells.begin(), row.cells.end(), [](const std::string& cell) { return !cell.empty(); });
}

std::string head(const Report& report, const std::vector<render::Reference>& references) {
  std::string html = "<thead><tr><th scope=\"col\">Measure</th>";
  const bool alone = report.runs.size() == 1;
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    html += fmt::format("<th scope=\"col\">{}{}</th>", alone ? "" : line_sample(fmt::format("v{}", i)),
                        alone ? "This run" : escaped(report.runs[i].label));
  for (std::size_t i = 0; i < references.size(); ++i)
    html +=
        fmt::format("<th scope=\"col\">{}{}</th>", line_sample(fmt::format("r{}", i)), escaped(references[i].label));
  return html + "</tr></thead>\n";
}

// The note's letter; each note is listed once.
std::string note_mark(const std::string& note, std::vector<std::string>& notes) {
  if (note.empty()) return "";
  const auto found = std::find(notes.begin(), notes.end(), note);
  const std::size_t number = found - notes.begin();
  if (found == notes.end()) notes.push_back(note);
  return fmt::format("<sup><a href=\"#note-{0}\">{0}</a></sup>", static_cast<char>('a' + number));
}

// An empty cell of a run says that it isn't known.
std::string body_row(const Row& row, std::size_t runs, std::size_t references, std::vector<std::string>& notes) {
  std::string html =
      fmt::format("<tr><th scope=\"row\">{}{}{}</th>", row.name,
                  row.unit.empty() ? "" : fmt::format(" <span>[{}]</span>", row.unit), note_mark(row.note, notes));
  for (std::size_t i = 0; i < runs + references; ++i) {
    const std::string cell = i < row.cells.size() ? row.cells[i] : "";
    html += fmt::format("<td>{}</td>", cell.empty() && i < runs ? "–" : cell);
  }
  return html + "</tr>\n";
}

}  // namespace

std::string table_html(const Report& report) {
  const Measured sensors = measured_sensors(report.runs.front().run);
  const std::vector<render::Reference> references = references_of(report, sensors.elevation);
  std::vector<Row> rows{{"Outcome", "", "", cells(report, outcome_cell)}};
  add_measures(report, references, sensors, rows);
  add_costs(report, rows);

  std::vector<std::string> notes;
  std::string html = "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of measures\">\n";
  html += "<table>\n";
  html += head(report, references) + "<tbody>\n";
  for (const Row& row : rows)
    if (is_known(row)) html += body_row(row, report.runs.size(), references.size(), notes);
  html += "</tbody>\n</table>\n</div>\n<ol class=\"notes\">\n";
  for (std::size_t i = 0; i < notes.size(); ++i)
    html += fmt::format("<li id=\"note-{}\">{}</li>\n", static_cast<char>('a' + i), escaped(notes[i]));
  return html + "</ol>\n";
}

}  // namespace seiche::apps::report
