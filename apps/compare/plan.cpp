#include "apps/compare/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <stdexcept>

#include "apps/output_folder.hpp"
#include "apps/run_info.hpp"
#include "apps/scene_file.hpp"
#include "apps/scene_text.hpp"
#include "apps/stored_run.hpp"

namespace seiche::apps::compare {
namespace {

Override set(const std::string& key, const std::string& value) { return parse_set(key + "=" + value); }

// Particles of liquid and walls, at most.
double particles(const Parameters& p) {
  constexpr double walls = 6;  // layers on both sides
  const double l0 = p.particles.spacing;
  const auto cells = [&](double size) { return size > 0 ? size / l0 + walls : 1; };
  return cells(p.tank.length) * cells(p.tank.height) * cells(p.tank.width);
}

}  // namespace

std::vector<PlannedRun> plan(const std::string& scene, const std::vector<std::string>& vary,
                             const std::vector<Override>& settings, const std::filesystem::path& folder) {
  std::vector<Vary> varied;
  std::vector<const Option*> keys;
  for (const std::string& each : vary) {
    varied.push_back(parse_vary(each));
    keys.push_back(varied.back().option);
  }
  std::vector<PlannedRun> runs;
  std::map<std::string, std::string> labels;  // by what is simulated
  for (const auto& values : combinations(varied, settings)) {
    PlannedRun run;
    run.settings = {set("output.pictures", "false"), set("output.movie", "none"), set("output.report", "false")};
    run.settings.insert(run.settings.end(), settings.begin(), settings.end());
    run.settings.insert(run.settings.end(), values.begin(), values.end());
    run.settings.insert(run.settings.end(), {set("output.vtu", "true"), set("output.probes", "true")});
    run.scene = read_scene(scene, run.settings);
    run.label = label_of(run.scene, keys);
    run.folder = folder / folder_of(run.scene, keys);
    const auto [same, is_new] = labels.emplace(simulated_hash(run.scene), run.label);
    if (!is_new)
      throw std::invalid_argument(
          fmt::format("--vary: {} and {} are the same run; leave one out", same->second, run.label));
    runs.push_back(std::move(run));
  }
  return runs;
}

std::string simulated_hash(const Scene& scene) {
  Scene plain = scene;
  plain.look = {};
  plain.output = {.probe_rate = scene.output.probe_rate, .frame_rate = scene.output.frame_rate};
  return scene_hash(plain);
}

bool is_done(const PlannedRun& run) {
  try {
    const StoredRun stored = read_run(run.folder);
    const auto& ending = stored.record.ending;
    return ending && ending->status != Ending::Status::interrupted && stored.info.version == version() &&
           simulated_hash(stored.scene) == simulated_hash(run.scene) && !stored_frames(stored).empty();
  } catch (const BadFolder&) {
    return false;  // not there, or half of it
  }
}

double memory_of(const Scene& scene) {
  constexpr double program = 150e6, flat = 2e3, solid = 10e3;  // the last two for each particle in 2-D, in 3-D
  return program + particles(scene.parameters) * (scene.parameters.dimension() == 3 ? solid : flat);
}

int runs_at_a_time(std::size_t runs, int cores, double need, double free) {
  return std::max(1, static_cast<int>(std::min({static_cast<double>(runs), static_cast<double>(cores), free / need})));
}

double free_memory() {
  std::ifstream lines("/proc/meminfo");
  std::string name;
  for (double kilobytes = 0; lines >> name >> kilobytes;
       lines.ignore(std::numeric_limits<std::streamsize>::max(), '\n'))
    if (name == "MemAvailable:") return 1024 * kilobytes;
  return std::numeric_limits<double>::infinity();
}

}  // namespace seiche::apps::compare
