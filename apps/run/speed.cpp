#include "apps/run/speed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace seiche::apps {
namespace {

constexpr double minor = 0.1;  // stages with a smaller share of the time come as "other"

double sum(const std::map<std::string, double>& seconds) {
  double result = 0;
  for (const auto& [name, value] : seconds) result += value;
  return result;
}

// With three digits that count and commas between thousands, as in "1,230,000".
std::string rounded_count(double value) {
  if (value < 1) return "0";
  const double unit = std::pow(10, std::max(0.0, std::floor(std::log10(value)) - 2));
  std::string text = fmt::format("{:.0f}", std::round(value / unit) * unit);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string short_seconds(double seconds) { return fmt::format("{:.{}f} s", seconds, seconds < 9.95 ? 1 : 0); }

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

// Names and values, the greatest first.
std::vector<std::pair<std::string, double>> sorted(const std::map<std::string, double>& seconds) {
  std::vector<std::pair<std::string, double>> result(seconds.begin(), seconds.end());
  std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  return result;
}

}  // namespace

double Times::solver() const { return sum(stages); }

double particle_steps_per_second(const Statistics& statistics, const Times& times) {
  const double seconds = times.solver();
  return seconds > 0 ? static_cast<double>(statistics.fluid_particles) * static_cast<double>(statistics.steps) / seconds
                     : 0;
}

double waited_share(const Times& times) { return times.total > 0 ? times.waited / times.total : 0; }

std::string speed_text(const Statistics& statistics, const Times& times) {
  const double all = times.solver();
  std::string result = rounded_count(particle_steps_per_second(statistics, times)) + " particle-steps a second";
  const char* before = ": ";
  double other = 0;
  for (const auto& [stage, seconds] : sorted(times.stages)) {
    if (seconds < minor * all) {
      other += seconds;
      continue;
    }
    result += fmt::format("{}{} {}", std::exchange(before, ", "), stage, percent(seconds / all));
  }
  if (other > 0) result += fmt::format("{}other {}", before, percent(other / all));
  return result;
}

std::string outputs_text(const Times& times) {
  std::string result;
  for (const auto& [output, seconds] : sorted(times.outputs)) {
    if (!result.empty() && seconds < 0.05) continue;
    result += fmt::format("{}{} {}", result.empty() ? "" : ", ", output, short_seconds(seconds));
  }
  return fmt::format("{}, beside the steps; held the run up for {} ({})", result, short_seconds(times.waited),
                     percent(waited_share(times)));
}

}  // namespace seiche::apps
