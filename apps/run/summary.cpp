#include "apps/run/summary.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace seiche::apps {
namespace {

std::string ending_sentence(const Ending& ending) {
  switch (ending.status) {
    case Ending::Status::finished:
      return fmt::format("Finished at t = {:.4g} s", ending.time);
    case Ending::Status::interrupted:
      return fmt::format("Interrupted at t = {:.4g} s", ending.time);
    case Ending::Status::failed:
      break;
  }
  return fmt::format("the run failed: {}\nKept", ending.reason());
}

std::string losses(const Statistics& s) {
  std::string result;
  if (s.leaked > 0)
    result += fmt::format("  warning   {} fluid particle{} leaked through a wall, taken out\n", s.leaked,
                          s.leaked == 1 ? "" : "s");
  if (s.spilled > 0)
    result += fmt::format("  note      {} fluid particle{} spilled over the rim, taken out\n", s.spilled,
                          s.spilled == 1 ? "" : "s");
  return result;
}

std::string speed(const RunRecord& record) {
  std::string result;
  if (record.statistics.steps > 0)
    result += fmt::format("  speed     {}\n", speed_text(record.statistics, record.times));
  if (!record.times.outputs.empty()) result += fmt::format("  outputs   {}\n", outputs_text(record.times));
  return result;
}

std::string written(const Scene& scene, const OutputFolder& folder) {
  std::string result;
  const auto add = [&](std::string_view what, const std::filesystem::path& path) {
    if (std::filesystem::exists(path)) result += fmt::format("  {:<9} {}\n", what, path.string());
  };
  for (const OutputRow& row : output_rows())
    if (scene.writes(row.kind)) add(row.title, folder.place(row.kind));
  add("record", folder.record());
  return result;
}

}  // namespace

std::string summary_text(const Scene& scene, const OutputFolder& folder, const RunRecord& record) {
  const Statistics& s = record.statistics;
  const double iterations = s.steps > 0 ? static_cast<double>(s.iterations) / static_cast<double>(s.steps) : 0;
  const long frames = record.ending->frames;
  return fmt::format("{}: {} frame{}, {} steps, {:.1f} pressure iterations a step, {} of wall time\n{}{}{}",
                     ending_sentence(*record.ending), frames, frames == 1 ? "" : "s", s.steps, iterations,
                     clock_text(record.times.total), losses(s), speed(record), written(scene, folder));
}

void print_summary(const Scene& scene, const OutputFolder& folder, const RunRecord& record, bool quiet) {
  const bool bad = record.ending->status == Ending::Status::failed;
  if (bad) fmt::print(stderr, "seiche: {}", summary_text(scene, folder, record));
  if (!bad && !quiet) fmt::print("{}", summary_text(scene, folder, record));
}

}  // namespace seiche::apps
