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

bool is_elevation(const std::string& name) { return name.starts_with("eta_"); }
bool is_pressure(const std::string& name) { return name.starts_with("p_"); }
using Columns = std::vector<std::size_t>;

void add(Columns& columns, std::size_t column) {
  if (columns.size() < most_curves && std::find(columns.begin(), columns.end(), column) == columns.end())
    columns.push_back(column);
}

Columns automatic(const std::vector<Reference>& references, const std::vector<std::string>& names) {
  Columns columns;
  for (const Reference& reference : references) {
    const auto found = std::find(names.begin(), names.end(), reference.of);
    if (found != names.end()) add(columns, static_cast<std::size_t>(found - names.begin()));
  }
  for (const auto is_of_kind : {is_elevation, is_pressure, is_motion}) {
    const auto drawn = [&](std::size_t column) { return is_of_kind(names[column]); };
    if (std::any_of(columns.begin(), columns.end(), drawn)) continue;
    const auto first = std::find_if(names.begin(), names.end(), is_of_kind);
    if (first != names.end()) add(columns, static_cast<std::size_t>(first - names.begin()));
  }
  return columns;
}

}  // namespace

std::optional<std::vector<std::string>> named_curves(const std::string& curves) {
  if (trimmed(curves) == "auto") return std::nullopt;
  std::vector<std::string> names;
  if (trimmed(curves) == "none") return names;
  for (std::size_t start = 0; start <= curves.size();) {
    const auto comma = std::min(curves.find(',', start), curves.size());
    names.push_back(trimmed(curves.substr(start, comma - start)));
    start = comma + 1;
  }
  if (names.size() > most_curves || std::find(names.begin(), names.end(), "") != names.end())
    throw std::invalid_argument(
        fmt::format("'{}' are no curves; give auto, none or up to {} sensors, as in \"eta_left, p_left_bottom\"",
                    curves, most_curves));
  return names;
}

std::string raised_powers(std::string unit) {
  for (const auto& [plain, raised] : {std::pair{"^2", "\u00b2"}, {"^3", "\u00b3"}})
    if (const auto place = unit.find(plain); place != std::string::npos) unit.replace(place, 2, raised);
  return unit;
}

bool is_motion(const std::string& name) { return name == "surge" || name == "heave" || name == "roll"; }

std::string bare_name(const std::string& column) { return trimmed(column.substr(0, column.find('['))); }

std::string curve_title(const std::string& column) {
  std::string name = bare_name(column), kind;
  const auto unit = column.find('[');
  if (is_elevation(name)) kind = "elevation, ", name.erase(0, 4);
  if (is_pressure(name)) kind = "pressure, ", name.erase(0, 2);
  std::replace(name.begin(), name.end(), '_', ' ');
  return fmt::format("{}{}{}{}", kind, name, unit == std::string::npos ? "" : " ",
                     unit == std::string::npos ? "" : raised_powers(column.substr(unit)));
}

std::vector<std::size_t> chosen_columns(const Look& look, const std::vector<std::string>& sensors) {
  std::vector<std::string> names;
  for (const std::string& column : sensors) names.push_back(bare_name(column));
  const auto wanted = named_curves(look.curves);
  if (!wanted) return automatic(look.references, names);
  Columns columns;
  for (const std::string& name : *wanted) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::invalid_argument(fmt::format("the run has no sensor '{}'", name));
    add(columns, static_cast<std::size_t>(found - names.begin()));
  }
  return columns;
}

}  // namespace seiche::render
