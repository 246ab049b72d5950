#include "apps/run/stored_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>

#include "apps/common/csv.hpp"
#include "apps/common/output_folder.hpp"
#include "apps/run/run_info.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

OutputFolder files_of(const StoredRun& run) { return {run.folder, run.scene.name}; }

// 123 of ..._000123.vtu.
long index_in(const fs::path& file) {
  const std::string stem = file.stem();
  const std::size_t first = stem.find_last_not_of("0123456789") + 1;
  long index = 0;
  std::from_chars(stem.data() + first, stem.data() + stem.size(), index);
  return index;
}

// Fit for a user, who knows nothing of the library.
std::string reason_of(const nlohmann::json::exception& error) {
  if (const auto* damage = dynamic_cast<const nlohmann::json::parse_error*>(&error))
    return fmt::format("it is damaged or cut off at byte {}; run it again", damage->byte);
  const std::string what = error.what();
  return fmt::format("it isn't as Seiche writes it: {}", what.substr(std::min(what.size(), what.find("] ") + 2)));
}

}  // namespace

StoredRun read_run(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw BadFolder(fmt::format("{} {}; expected the folder of a run, as `seiche run` leaves it", folder.string(),
                                fs::exists(folder) ? "is a file" : "isn't there"));
  fs::path file = folder / "run.json";
  if (!fs::is_regular_file(file))
    throw BadFolder(fmt::format("{} {}; expected the folder of a run, as `seiche run` leaves it", folder.string(),
                                fs::is_empty(folder) ? "is empty" : "has no run.json"));
  StoredRun run;
  run.folder = folder;
  try {
    const auto json = nlohmann::json::parse(render::read_file(file));
    read_run_json(json, folder, run.scene, run.record);
    if (const fs::path more = files_of(run).samples(); fs::exists(more))
      read_samples(nlohmann::json::parse(render::read_file(file = more)), run.scene);
    run.info = run_info(run.scene);
    run.info.version = json.at("seiche");
  } catch (const nlohmann::json::exception& error) {
    throw BadFolder(fmt::format("{} can't be used: {}", file.string(), reason_of(error)));
  } catch (const std::exception& error) {
    throw BadFolder(fmt::format("{} can't be used: {}", file.string(), error.what()));
  }
  return run;
}

std::vector<StoredFrame> stored_frames(const StoredRun& run) {
  const fs::path list = run.folder / (run.scene.name + ".vtu.series");
  std::vector<StoredFrame> frames;
  if (!fs::exists(list)) return frames;
  try {
    const auto json = nlohmann::json::parse(render::read_file(list));
    for (const auto& entry : json.at("files")) {
      const std::string name = entry.at("name");
      frames.push_back({index_in(name), entry.at("time"), run.folder / name});
    }
  } catch (const nlohmann::json::exception& error) {
    throw BadFolder(fmt::format("{} can't be used: {}", list.string(), reason_of(error)));
  }
  return frames;
}

void check_there(const std::vector<StoredFrame>& frames) {
  for (const StoredFrame& frame : frames)
    if (!fs::exists(frame.file))
      throw BadFolder(fmt::format("{} isn't there, though the run lists it; run it again", frame.file.string()));
}

std::vector<fs::path> stored_pictures(const StoredRun& run) {
  std::vector<fs::path> pictures;
  const fs::path frames = files_of(run).frames();
  if (!fs::is_directory(frames)) return pictures;
  for (const auto& entry : fs::directory_iterator(frames)) {
    const std::string stem = entry.path().stem();
    if (entry.path().extension() == ".png" && stem.size() >= 6 && std::all_of(stem.begin(), stem.end(), isdigit))
      pictures.push_back(entry.path());
  }
  std::sort(pictures.begin(), pictures.end(), [](const auto& a, const auto& b) { return index_in(a) < index_in(b); });
  return pictures;
}

Readings stored_readings(const StoredRun& run) {
  Readings readings;
  const fs::path file = files_of(run).probes();
  if (!fs::exists(file)) return readings;
  std::string text = render::read_file(file);
  text.erase(text.rfind('\n') + 1);
  const Csv table(text, file.string());
  std::vector<std::string> titles{"t [s]"};
  for (const Column& column : run.info.sensors) titles.push_back(header(column));
  if (table.titles() != titles)
    throw BadFolder(fmt::format("{} has other columns than the sensors in run.json", file.string()));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    readings.time.push_back(table.number(row, 0));
    for (std::size_t k = 1; k < titles.size(); ++k) readings.values.push_back(table.number_or_gap(row, k));
  }
  return readings;
}

render::Series column_of(const Readings& readings, const RunInfo& info, const std::string& sensor) {
  const std::size_t found = find_column(info.sensors, sensor), width = info.sensors.size();
  render::Series series;
  if (found == width) return series;
  series.time = readings.time;
  for (std::size_t k = found; k < readings.values.size(); k += width) series.value.push_back(readings.values[k]);
  return series;
}

}  // namespace seiche::apps
