#include "apps/validate/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace seiche::apps::validate {
namespace {

std::string reason_of(const Figure& figure) { return figure.is_known_miss() ? figure.known->reason : ""; }

// The verdict, and why where that is known.
std::string judgement(const Figure& figure) {
  const std::string reason = reason_of(figure);
  return verdict(figure) + (reason.empty() ? "" : ": " + reason);
}

std::string cell(double value) { return std::isinf(value) ? "" : fmt::format("{:.6g}", value); }

}  // namespace

bool Outcome::passed() const {
  return failure.empty() && std::all_of(findings.figures.begin(), findings.figures.end(),
                                        [](const Figure& figure) { return figure.met() || figure.is_known_miss(); });
}

std::string figures_text(const Outcome& outcome) {
  if (!outcome.failure.empty()) return fmt::format("  {} failed: {}\n", outcome.name, outcome.failure);
  std::size_t width = 0;
  for (const Figure& figure : outcome.findings.figures) width = std::max(width, figure.name.size());
  std::string text;
  for (const Figure& figure : outcome.findings.figures)
    text += fmt::format("  {:<{}}  {:>12}  {:>12}  {}\n", figure.name, width, value_text(figure), target_text(figure),
                        judgement(figure));
  return text;
}

std::string table_md(const std::vector<Outcome>& outcomes) {
  std::string text = "| case | figure | value | target | |\n|---|---|---|---|---|\n";
  for (const Outcome& outcome : outcomes) {
    std::string name = outcome.name;
    if (!outcome.failure.empty()) text += fmt::format("| {} | failed: {} | | | |\n", name, outcome.failure);
    for (const Figure& figure : outcome.findings.figures) {
      text += fmt::format("| {} | {} | {} | {} | {} |\n", name, figure.name, value_text(figure), target_text(figure),
                          judgement(figure));
      name.clear();
    }
  }
  return text;
}

std::string table_csv(const std::vector<Outcome>& outcomes) {
  std::string text = "case,figure,value,unit,low,high,verdict,reason\n";
  for (const Outcome& outcome : outcomes) {
    if (!outcome.failure.empty()) text += fmt::format("{},\"failed: {}\",,,,,,\n", outcome.name, outcome.failure);
    for (const Figure& figure : outcome.findings.figures) {
      const Target target = figure.target.value_or(Target{});
      text += fmt::format("{},\"{}\",{:.6g},{},{},{},\"{}\",\"{}\"\n", outcome.name, figure.name, figure.value,
                          figure.unit, cell(target.low), cell(target.high), verdict(figure), reason_of(figure));
    }
  }
  return text;
}

std::string count_text(const std::vector<Outcome>& outcomes) {
  int all = 0, missed = 0, known = 0, open = 0, failed = 0;
  for (const Outcome& outcome : outcomes) {
    failed += !outcome.failure.empty();
    for (const Figure& figure : outcome.findings.figures) {
      ++all;
      known += figure.is_known_miss();
      missed += !figure.met() && !figure.is_known_miss();
      open += !figure.target;
    }
  }
  return fmt::format("{} figures: {} met, {} missed, {} known miss{}, {} without a target{}", all,
                     all - missed - known - open, missed, known, known == 1 ? "" : "es", open,
                     failed ? fmt::format("; {} cases failed", failed) : "");
}

}  // namespace seiche::apps::validate
