#include "apps/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "apps/report/chart.hpp"
#include "apps/report/columns.hpp"
#include "apps/report/curves.hpp"
#include "apps/report/html.hpp"

namespace seiche::apps::report {
namespace {

// Letters of the notes, each of which is listed once.
class Notes {
 public:
  // As HTML; nothing for an empty note.
  std::string mark(const std::string& note) {
    if (note.empty()) return "";
    const auto found = std::find(notes_.begin(), notes_.end(), note);
    const auto number = found - notes_.begin();
    if (found == notes_.end()) notes_.push_back(note);
    return fmt::format("<sup><a href=\"#note-{0}\">{0}</a></sup>", static_cast<char>('a' + number));
  }

  std::string list() const {
    std::string html = "<ol class=\"notes\">\n";
    for (std::size_t i = 0; i < notes_.size(); ++i)
      html += fmt::format("<li id=\"note-{}\">{}</li>\n", static_cast<char>('a' + i), escaped(notes_[i]));
    return html + "</ol>\n";
  }

 private:
  std::vector<std::string> notes_;
};

std::string group_heads(const std::vector<Column>& columns) {
  std::string html;
  for (auto column = columns.begin(); column != columns.end();) {
    const auto next = std::find_if(column, columns.end(), [&](const Column& c) { return c.group != column->group; });
    html += column->group.empty()
                ? fmt::format("<th scope=\"col\" rowspan=\"2\" class=\"words\">{}</th>", column->name)
                : fmt::format("<th scope=\"colgroup\" class=\"group\" colspan=\"{}\"><span>{}</span></th>",
                              next - column, escaped(column->group));
    column = next;
  }
  return html;
}

// What a cell is, where the table has become cards and has no heads.
std::string name_in_card(const Column& column, const std::string& mark) {
  return fmt::format("{}{}{}", escaped(column.name), mark,
                     column.unit.empty() ? "" : fmt::format(", <i>{}</i>", escaped(column.unit)));
}

std::string head(const std::vector<Column>& columns, const std::vector<std::string>& marks) {
  std::string html =
      "<thead>\n<tr><th scope=\"col\" rowspan=\"2\" class=\"words\">Run</th>" + group_heads(columns) + "</tr>\n<tr>";
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (!columns[i].group.empty())
      html += fmt::format("<th scope=\"col\">{}{}<span>{}</span></th>", escaped(columns[i].name), marks[i],
                          columns[i].unit.empty() ? "&nbsp;" : escaped(columns[i].unit));
  return html + "</tr>\n</thead>\n";
}

// An empty cell of a run says that it isn't known.
std::string row(const std::string& name, const std::optional<LineStyle>& style, const std::vector<Column>& columns,
                const std::vector<std::string>& marks, std::size_t number, bool run) {
  std::string html = fmt::format("<tr{}>\n<th scope=\"row\"><div>{}<span>{}</span></div></th>\n",
                                 run ? "" : " class=\"theirs\"", style ? line_sample(*style) : "", escaped(name));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Cell cell = number < columns[i].cells.size() ? columns[i].cells[number] : Cell{};
    if (cell.value.empty()) {
      html += fmt::format("<td class=\"none\">{}</td>\n", run ? "–" : "");
      continue;
    }
    html += fmt::format("<td{}><span class=\"name\">{}</span>{}{}</td>\n",
                        columns[i].group.empty() ? " class=\"words\"" : "", name_in_card(columns[i], marks[i]),
                        escaped(cell.value),
                        cell.aside.empty() ? "" : fmt::format(" <small>{}</small>", escaped(cell.aside)));
  }
  return html + "</tr>\n";
}

}  // namespace

std::string table_html(const Report& report) {
  const Measured sensors = measured_sensors(report.runs.front().run);
  const std::vector<render::Reference> references =
      sensors.elevation ? references_of(report, sensors.elevation->name) : std::vector<render::Reference>();
  const std::vector<Column> columns = columns_of(report, sensors, references);
  const bool alone = report.runs.size() == 1;

  Notes notes;
  std::vector<std::string> marks;
  for (const Column& column : columns) marks.push_back(notes.mark(column.note));
  std::string html =
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Table of measures\">\n<table>\n" +
      head(columns, marks) + "<tbody>\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    html += row(alone ? "This run" : report.runs[i].label, alone ? std::nullopt : std::optional(run_line(i)), columns,
                marks, i, true);
  for (std::size_t i = 0; i < references.size(); ++i)
    html += row(references[i].label, reference_line(i), columns, marks, report.runs.size() + i, false);
  return html + "</tbody>\n</table>\n</div>\n" + notes.list();
}

}  // namespace seiche::apps::report
