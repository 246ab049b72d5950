#include "render/curves/curve_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace seiche::render {
namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

using Chosen = std::vector<std::size_t>;

bool is_elevation(const Column& column) { return column.kind == ColumnKind::elevation; }
bool is_pressure(const Column& column) { return column.kind == ColumnKind::pressure; }

void add(Chosen& chosen, std::size_t column) {
  if (chosen.size() < most_curves && std::find(chosen.begin(), chosen.end(), column) == chosen.end())
    chosen.push_back(column);
}

Chosen automatic(const std::vector<Reference>& references, const std::vector<Column>& sensors) {
  Chosen chosen;
  for (const Reference& reference : references)
    if (const std::size_t found = find_column(sensors, reference.of); found < sensors.size()) add(chosen, found);
  for (const auto is_of_kind : {is_elevation, is_pressure, is_motion}) {
    const auto drawn = [&](std::size_t column) { return is_of_kind(sensors[column]); };
    if (std::any_of(chosen.begin(), chosen.end(), drawn)) continue;
    const auto first = std::find_if(sensors.begin(), sensors.end(), is_of_kind);
    if (first != sensors.end()) add(chosen, static_cast<std::size_t>(first - sensors.begin()));
  }
  return chosen;
}

}  // namespace

CurveChoice parse_curves(const std::string& text) {
  if (trimmed(text) == "auto") return std::nullopt;
  std::vector<std::string> names;
  if (trimmed(text) == "none") return names;
  for (std::size_t start = 0; start <= text.size();) {
    const auto comma = std::min(text.find(',', start), text.size());
    names.push_back(trimmed(text.substr(start, comma - start)));
    start = comma + 1;
  }
  if (names.size() > most_curves || std::find(names.begin(), names.end(), "") != names.end())
    throw std::invalid_argument(
        fmt::format("'{}' are no curves; give auto, none or up to {} sensors, as in \"eta_left, p_left_bottom\"", text,
                    most_curves));
  return names;
}

std::string text_of(const CurveChoice& curves) {
  if (!curves) return "auto";
  return curves->empty() ? "none" : fmt::format("{}", fmt::join(*curves, ", "));
}

std::string raised_powers(std::string unit) {
  for (const auto& [plain, raised] : {std::pair{"^2", "\u00b2"}, {"^3", "\u00b3"}})
    if (const auto place = unit.find(plain); place != std::string::npos) unit.replace(place, 2, raised);
  return unit;
}

std::string curve_title(const Column& column) {
  return fmt::format("{} [{}]", column.title, raised_powers(column.unit));
}

std::vector<std::size_t> chosen_columns(const Look& look, const std::vector<Column>& sensors) {
  if (!look.curves) return automatic(look.references, sensors);
  Chosen chosen;
  for (const std::string& name : *look.curves) {
    const std::size_t found = find_column(sensors, name);
    if (found == sensors.size()) throw std::invalid_argument(fmt::format("the run has no sensor '{}'", name));
    add(chosen, found);
  }
  return chosen;
}

}  // namespace seiche::render
