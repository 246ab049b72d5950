#include "apps/report/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "apps/report/curves.hpp"
#include "apps/report/words.hpp"

namespace seiche::apps::report {
namespace {

template <class All, class F>
std::vector<Cell> cells(const All& all, F cell) {
  std::vector<Cell> result;
  for (const auto& each : all) result.push_back(cell(each));
  return result;
}

// With a true minus sign, which is as long as the plus.
std::string signed_text(double value) { return fmt::format("{}{:.2g}", value < 0 ? "\u2212" : "+", std::abs(value)); }

// A figure over other times than most are, since its run stopped sooner, isn't to be compared with them without a word.
bool ends_early(double to, const std::vector<double>& all) {
  return to < 0.99 * *std::max_element(all.begin(), all.end());
}

// Of no sensor there are no figures either, and their column is left out.
std::string heading(const std::optional<seiche::Column>& sensor) { return sensor ? heading_of(*sensor) : ""; }

Column noise_column(const std::vector<Measures>& all, const Measured& sensors) {
  std::vector<double> ends{0};
  for (const Measures& one : all)
    if (one.noise) ends.push_back(one.noise->to);
  const auto cell = [&](const Measures& one) {
    if (!one.noise) return Cell{};
    return Cell{fmt::format("{:.3g}", 100 * one.noise->value),
                ends_early(one.noise->to, ends) ? fmt::format("{:.3g}–{:.3g} s", one.noise->from, one.noise->to) : ""};
  };
  return {heading(sensors.pressure), "Noise", "% of ρgh",
          "Root mean square of what lies above 10 Hz in the pressure, over the weight of the still liquid, ρ g h; "
          "from 0.5 to 3 s, or all of a run that ends within a second.",
          cells(all, cell)};
}

// Whether the figure above each panel is of this sensor.
bool is_above_panels(const Report& report, const std::optional<seiche::Column>& sensor) {
  const std::vector<seiche::Column> columns = charted(report.runs.front().run);
  const auto first = std::find_if(columns.begin(), columns.end(), [&](const seiche::Column& column) {
    return !references_of(report, column.name).empty();
  });
  return report.runs.size() > 1 && first != columns.end() && *first == sensor;
}

Column error_column(const Report& report, const std::vector<Measures>& all, const Measured& sensors,
                    const render::Reference& reference, std::size_t number) {
  std::vector<double> ends{0};
  for (const Measures& one : all)
    if (one.errors[number]) ends.push_back(one.errors[number]->to);
  const auto cell = [&](const Measures& one) {
    const auto& error = one.errors[number];
    if (!error) return Cell{};
    Cell result{fmt::format("{:.1f}", 1000 * error->rms), ""};
    if (ends_early(error->to, ends))
      result.aside = fmt::format("to {:.2g} s", error->to);
    else if (std::isfinite(error->of_rest))
      result.aside = fmt::format("{:.0f} %", 100 * error->of_rest);
    return result;
  };
  const bool told = number == 0 && is_above_panels(report, sensors.elevation);
  return {
      heading(sensors.elevation), "Off " + reference.label, "mm RMS",
      fmt::format("Root mean square of the difference from the reference over the times that both have{}; in small, "
                  "in % of the same of still liquid.",
                  told ? ", as above the panels at the movie’s end where there is room" : ""),
      cells(all, cell)};
}

Cell crest_cell(const std::vector<Crest>& crests, std::size_t number) {
  if (number >= crests.size()) return {};
  const double height = 1000 * crests[number].height;
  return {fmt::format("{}{:.1f}", height < -0.05 ? "\u2212" : "", std::abs(height)),
          fmt::format("at {:.2f} s", crests[number].time)};
}

void add_crests(const Report& report, const std::vector<Measures>& all, const Measured& sensors,
                const std::vector<render::Reference>& references, std::vector<Column>& columns) {
  const ReportRun& first = report.runs.front();
  const bool compared = !references.empty();
  const std::string note =
      compared
          ? "The highest point within a quarter of a period of a crest of the first reference."
          : "The highest point of a wave between a rise above 1 % of the depth and a fall as far below still level.";
  const double reach = crest_reach(first.run.scene);
  const auto leading =
      compared ? crests_of(references.front().series, least_crest(first.run.info), most_crests) : std::vector<Crest>();
  for (std::size_t number = 0; number < most_crests; ++number) {
    Column column{heading(sensors.elevation), fmt::format("Crest\u00a0{}", number + 1), "mm", note,
                  cells(all, [&](const Measures& one) { return crest_cell(one.crests, number); })};
    for (const render::Reference& reference : references)
      column.cells.push_back(crest_cell(crests_near(reference.series, leading, reach), number));
    columns.push_back(std::move(column));
  }
}

// Statistics of a run without an ending were last written before its first step.
template <class F>
std::vector<Cell> known_cells(const Report& report, F text) {
  return cells(report.runs, [&](const ReportRun& run) { return run.run.record.ending ? Cell{text(run), ""} : Cell{}; });
}

void add_liquid(const Report& report, const std::vector<Measures>& all, std::vector<Column>& columns) {
  columns.push_back({"Liquid", "Drift", "%",
                     "Of the level: mean volume below the surface in the last tenth of the run, less that in the "
                     "first.",
                     cells(all, [](const Measures& one) {
                       return Cell{one.drift ? signed_text(100 * *one.drift) : std::string(), ""};
                     })});
  columns.push_back({"Liquid", "Lost", "", "Liquid particles that leaked through a wall or spilled over the rim.",
                     known_cells(report, [](const ReportRun& run) {
                       return fmt::format("{}", run.run.record.statistics.leaked + run.run.record.statistics.spilled);
                     })});
  columns.push_back(
      {"Liquid", "Least distance", "l₀",
       "Of any two particles in any step, in initial spacings l₀: 1 at rest, and the lower, the worse they clump.",
       known_cells(report, [](const ReportRun& run) {
         const double least = run.run.record.statistics.least_distance;
         return std::isfinite(least) ? fmt::format("{:.2g}", least / run.run.scene.parameters.particles.spacing) : "";
       })});
}

void add_costs(const Report& report, std::vector<Column>& columns) {
  columns.push_back({"Cost", "Steps", "", "", known_cells(report, [](const ReportRun& run) {
                       return fmt::format("{}", run.run.record.statistics.steps);
                     })});
  columns.push_back(
      {"Cost", "Iterations", "a step", "Of the pressure solver.", known_cells(report, [](const ReportRun& run) {
         const Statistics& s = run.run.record.statistics;
         return s.steps > 0 ? fmt::format("{:.1f}", static_cast<double>(s.iterations) / static_cast<double>(s.steps))
                            : "";
       })});
  columns.push_back({"Cost", "Wall time", "s", "", known_cells(report, [](const ReportRun& run) {
                       return fmt::format("{:.1f}", run.run.record.times.total);
                     })});
}

}  // namespace

std::vector<Column> columns_of(const Report& report, const Measured& sensors,
                               const std::vector<render::Reference>& references) {
  std::vector<Measures> all;
  for (const ReportRun& run : report.runs) all.push_back(measures_of(run, sensors, references));
  std::vector<Column> columns{{"", "Outcome", "", "", cells(report.runs, [](const ReportRun& run) {
                                 const Outcome outcome = outcome_of(run);
                                 return Cell{outcome.what, outcome.time};
                               })}};
  columns.push_back(noise_column(all, sensors));
  for (std::size_t i = 0; i < references.size(); ++i)
    columns.push_back(error_column(report, all, sensors, references[i], i));
  add_crests(report, all, sensors, references, columns);
  add_liquid(report, all, columns);
  add_costs(report, columns);
  std::erase_if(columns, [&](const Column& column) {
    return std::all_of(column.cells.begin(), column.cells.begin() + static_cast<std::ptrdiff_t>(report.runs.size()),
                       [](const Cell& cell) { return cell.value.empty(); });
  });
  return columns;
}

}  // namespace seiche::apps::report
