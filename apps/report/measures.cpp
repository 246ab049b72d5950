#include "apps/report/measures.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "apps/common/filter.hpp"
#include "apps/report/curves.hpp"
#include "render/panels.hpp"

namespace seiche::apps::report {
namespace {

constexpr double cut = 10;  // [Hz]; sloshing is slower, what a scheme adds from step to step is faster

// Without its gaps.
Series finite(const render::Series& series) {
  Series result;
  for (std::size_t i = 0; i < series.time.size(); ++i) {
    if (!std::isfinite(series.value[i])) continue;
    result.t.push_back(series.time[i]);
    result.y.push_back(series.value[i]);
  }
  return result;
}

// 0.5 to 3 s, before which a start rings and after which waves may break; all of a run that ends within a second.
std::optional<Share> noise_of(const render::Series& pressure, const RunInfo& run) {
  const double weight = run.density * run.gravity * run.depth;
  if (pressure.time.empty() || weight == 0) return {};
  const double end = pressure.time.back();
  Share noise{0, end < 1 ? pressure.time.front() : 0.5, std::min(end, 3.0)};
  try {
    noise.value = apps::noise(finite(pressure), noise.from, noise.to, cut) / weight;
  } catch (const std::runtime_error&) {
    return {};  // too few readings, or too seldom
  }
  return noise;
}

std::optional<Error> error_of(const render::Series& elevation, const render::Series& reference) {
  if (elevation.time.empty()) return {};
  render::Series rest = elevation;
  for (double& value : rest.value) value *= 0;  // a gap stays one
  const double end = elevation.time.back(), rms = render::deviation(elevation, reference, end);
  if (!std::isfinite(rms)) return {};
  return Error{rms, end, rms / render::deviation(rest, reference, end)};
}

std::optional<double> drift_of(const render::Series& volume) {
  const std::vector<double> values = finite(volume).y;
  const auto part = static_cast<std::ptrdiff_t>(values.size() / 10);
  if (part == 0) return {};
  const auto mean = [&](auto first) { return std::accumulate(first, first + part, 0.0) / static_cast<double>(part); };
  const double before = mean(values.begin());
  if (before == 0) return {};
  return mean(values.end() - part) / before - 1;
}

std::optional<seiche::Column> first_of(const std::vector<seiche::Column>& columns, ColumnKind kind) {
  for (const seiche::Column& column : columns)
    if (column.kind == kind) return column;
  return {};
}

// Empty where there is no such column.
render::Series readings_of(const ReportRun& one, const std::optional<seiche::Column>& column) {
  return column ? column_of(one.readings, one.run.info, column->name) : render::Series();
}

}  // namespace

Measured measured_sensors(const StoredRun& run) {
  std::vector<seiche::Column> columns = charted(run);
  columns.insert(columns.end(), run.info.sensors.begin(), run.info.sensors.end());
  return {first_of(columns, ColumnKind::pressure), first_of(columns, ColumnKind::elevation)};
}

Measures measures_of(const ReportRun& one, const Measured& sensors, const std::vector<render::Reference>& references) {
  const RunInfo& info = one.run.info;
  const double reach = crest_reach(one.run.scene);
  const render::Series elevation = readings_of(one, sensors.elevation);
  Measures measures;
  measures.noise = noise_of(readings_of(one, sensors.pressure), info);
  for (const render::Reference& reference : references)
    measures.errors.push_back(error_of(elevation, reference.series));
  const render::Series& leading = references.empty() ? elevation : references.front().series;
  measures.crests = crests_of(leading, least_crest(info), most_crests);
  if (!references.empty()) measures.crests = crests_near(elevation, measures.crests, reach);
  measures.drift = drift_of(readings_of(one, first_of(info.sensors, ColumnKind::volume)));
  return measures;
}

std::vector<Crest> crests_of(const render::Series& elevation, double least, std::size_t most) {
  std::vector<Crest> crests;
  std::optional<Crest> now;
  for (std::size_t i = 0; i < elevation.time.size() && crests.size() < most; ++i) {
    const double height = elevation.value[i];
    if (height > least && (!now || height > now->height)) now = Crest{elevation.time[i], height};
    if (height < -least && now) {
      crests.push_back(*now);
      now.reset();
    }
  }
  return crests;
}

std::vector<Crest> crests_near(const render::Series& elevation, const std::vector<Crest>& crests, double reach) {
  std::vector<Crest> found;
  for (const Crest& crest : crests) {
    if (elevation.time.empty() || elevation.time.back() < crest.time + reach) break;
    std::optional<Crest> highest;
    for (std::size_t i = 0; i < elevation.time.size(); ++i) {
      const double time = elevation.time[i], height = elevation.value[i];
      if (std::abs(time - crest.time) <= reach && (!highest || height > highest->height)) highest = Crest{time, height};
    }
    if (!highest) break;
    found.push_back(*highest);
  }
  return found;
}

double crest_reach(const Scene& scene) {
  const double frequency = scene.parameters.motion.harmonic.frequency;
  return frequency > 0 ? 0.25 / frequency : 0.25;
}

double least_crest(const RunInfo& run) { return 0.01 * run.depth; }

}  // namespace seiche::apps::report
