#include "apps/compare/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "apps/common/output_folder.hpp"
#include "apps/run/run_info.hpp"
#include "apps/run/stored_run.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "apps/scene/variants.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::compare {
namespace {

Override set(const std::string& key, const std::string& value) { return parse_set(key + "=" + value); }

// Particles of liquid and walls, at most.
double particles(const Parameters& p) {
  constexpr double walls = 6;  // layers on both sides
  const double l0 = p.particles.spacing;
  const auto cells = [&](double size) { return size > 0 ? size / l0 + walls : 1; };
  const auto [length, height, width] = tank_surface(p).size();
  return cells(length) * cells(height) * cells(width);
}

void refuse_what_pictures_need(const std::vector<Override>& settings) {
  for (const Override& each : settings)
    if ((each.key == "output.vtu" || each.key == "output.probes") && each.value == "false")
      throw std::invalid_argument(
          fmt::format("{}: the comparison is drawn from VTU files and readings; leave it out", each.origin));
}

// As the user typed them, as in "method.kernel=KF1 particles.spacing=0.02".
std::string typed(const std::vector<Override>& values) {
  std::string all;
  for (const Override& each : values) all += fmt::format("{}{}={}", all.empty() ? "" : " ", each.key, each.value);
  return all;
}

void refuse_clashes(const std::vector<PlannedRun>& runs, const std::vector<std::vector<Override>>& values) {
  const auto refuse = [&](std::size_t i, std::size_t k, const std::string& what) {
    throw std::invalid_argument(fmt::format("--vary: {} and {} {}", typed(values[i]), typed(values[k]), what));
  };
  for (std::size_t k = 0; k < runs.size(); ++k) {
    for (std::size_t i = 0; i < k; ++i) {
      if (simulated_hash(runs[i].scene) == simulated_hash(runs[k].scene))
        refuse(i, k, "are the same run; leave one out");
      if (runs[i].folder == runs[k].folder) refuse(i, k, "would have the same folder; give one another name");
    }
    const int first = runs.front().scene.parameters.dimension(), other = runs[k].scene.parameters.dimension();
    if (first != other)
      refuse(0, k, fmt::format("are a {}-D run and a {}-D one; they can't share a picture", first, other));
  }
}

std::vector<const Scene*> scenes_of(const std::vector<PlannedRun>& runs) {
  std::vector<const Scene*> scenes;
  for (const PlannedRun& run : runs) scenes.push_back(&run.scene);
  return scenes;
}

// What is simulated, sampled and how often.
Scene simulated(Scene scene) {
  scene.look = {};
  scene.output = {.probe_rate = scene.output.probe_rate, .frame_rate = scene.output.frame_rate};
  return scene;
}

// The first key in which they differ, as in " with time.end = 0.3, not 0.2"; lists and files have no such value.
std::string difference(const Scene& stored, const Scene& planned) {
  const Scene a = simulated(stored), b = simulated(planned);
  for (const Option& option : options())
    if (const Value is = value_of(option, a), wanted = value_of(option, b); is != wanted)
      return fmt::format(" with {} = {}, not {}", dotted(option), text_of(is), text_of(wanted));
  return " with other parameters";
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
  refuse_what_pictures_need(settings);
  const auto combined = combinations(varied, settings);
  std::vector<PlannedRun> runs;
  for (const auto& values : combined) {
    PlannedRun run;
    run.settings = {set("output.pictures", "false"), set("output.movie", "none"), set("output.report", "false")};
    run.settings.insert(run.settings.end(), settings.begin(), settings.end());
    run.settings.insert(run.settings.end(), values.begin(), values.end());
    run.settings.insert(run.settings.end(), {set("output.vtu", "true"), set("output.probes", "true")});
    run.scene = read_scene(scene, run.settings);
    run.folder = folder / folder_of(run.scene, keys);
    runs.push_back(std::move(run));
  }
  refuse_clashes(runs, combined);
  const auto labels = labels_of(scenes_of(runs), keys);
  for (std::size_t i = 0; i < runs.size(); ++i) runs[i].label = labels[i];
  return runs;
}

std::string simulated_hash(const Scene& scene) { return scene_hash(simulated(scene)); }

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

void check_kept(const PlannedRun& run) {
  namespace fs = std::filesystem;
  OutputFolder{run.folder, run.scene.name}.check(true);
  if (!fs::exists(run.folder) || fs::is_empty(run.folder)) return;
  const auto refuse = [&](const std::string& what) {
    throw BadFolder(fmt::format("{} {}; choose another folder with -o DIR, or replace what is there with --overwrite",
                                run.folder.string(), what));
  };
  StoredRun stored;
  try {
    stored = read_run(run.folder);
  } catch (const BadFolder&) {
    refuse("isn't empty, and holds no run that can be read");
  }
  const auto& ending = stored.record.ending;
  const bool ended = ending && ending->status != Ending::Status::interrupted;
  const std::string held = ended ? "holds a finished run" : "holds an unfinished run";
  if (simulated_hash(stored.scene) != simulated_hash(run.scene)) refuse(held + difference(stored.scene, run.scene));
  if (ended && stored.info.version != version())
    refuse(fmt::format("{} of seiche {}, not {}", held, stored.info.version, version()));
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
