#include "apps/compare/compare.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <set>

#include "apps/common/exit_codes.hpp"
#include "apps/common/signals.hpp"
#include "apps/common/stopwatch.hpp"
#include "apps/compare/drawing.hpp"
#include "apps/compare/folder.hpp"
#include "apps/compare/runs.hpp"
#include "apps/report/command.hpp"
#include "apps/report/report.hpp"
#include "apps/scene/variants.hpp"
#include "render/check_look.hpp"
#include "render/outputs.hpp"
#include "render/panels.hpp"

namespace fs = std::filesystem;

namespace seiche::apps::compare {
namespace {

render::Look with_size(render::Look look, const std::string& size) {
  Scene scene;
  if (const auto complaint = assign(*find_option("output", "size"), scene, Value(size)))
    throw std::invalid_argument(fmt::format("--size {}: {}", size, *complaint));
  look.width = scene.look.width;
  look.height = scene.look.height;
  return look;
}

void check_pictures(const Request& request, const render::Look& look) {
  render::check_look(look);
  render::check_movie(files_in(request.folder).movie(request.movie), look.width, look.height);
  render::gl_description();
}

// What makes the comparison again.
std::string command_of(const Request& request) {
  std::vector<std::string> words{"compare"};
  words.insert(words.end(), request.what.begin(), request.what.end());
  for (const std::string& each : request.vary) words.insert(words.end(), {"--vary", each});
  if (request.movie != Request{}.movie)
    words.insert(words.end(), {"--movie", std::string(seiche::name(request.movie))});
  if (request.size != Request{}.size) words.insert(words.end(), {"--size", request.size});
  return report::command_text(words, request.settings);
}

// One page of all runs, with the movie and pictures that have been drawn.
void report_on(const std::vector<ComparedRun>& runs, const OutputFolder& files, const Request& request) {
  Report page{.title = fmt::format("{}, compared", runs.front().run.scene.name), .runs = {}, .movie = {}, .stills = {}};
  for (const ComparedRun& each : runs) page.runs.push_back({each.run, each.label, each.readings});
  page.movie = files.movie(request.movie);
  page.command = command_of(request);
  const Clock clock = clock_of(runs);
  page.stills = even_stills(stored_pictures({files.path, {}, {}, {}}), clock.interval, clock.end);
  write_report(files.report(), page);
}

// What comes after the runs: pictures, movie, and the last words.
int show(const Request& request, const std::vector<ComparedRun>& runs, const render::Look& look, const fs::path& folder,
         const SignalWatch& signals, const Stopwatch& watch) {
  const OutputFolder files = files_in(folder);
  Draft draft(folder);
  ProgressTable table(Progress::suitable(request.quiet));
  const Stopwatch drawing;
  const auto progress = [&](long number, long last) {
    ProgressRow row{.label = "pictures", .state = ProgressRow::State::running, .format = "{:.0f}/{:.0f}", .ending = {}};
    row.time = static_cast<double>(number + 1);
    row.end = static_cast<double>(last + 1);
    table.show({row}, drawing.seconds());
    return !signals.caught();
  };
  const bool whole = draw(runs, look, {draft.files().frames(), draft.files().movie(request.movie)}, progress);
  if (whole) report_on(runs, draft.files(), request);
  // Part of a movie is better than none, but not than an earlier one.
  const bool kept = !whole && is_drawn(folder);
  if (!kept) {
    draft.publish();
    std::vector<ShownRun> folders;
    for (const ComparedRun& each : runs) folders.push_back({each.label, each.run.folder});
    write_note(folder, folders);
  }
  if (!request.quiet) {
    fmt::print("{} after {}{}\n", whole ? "Done" : "Interrupted", clock_text(watch.seconds()),
               kept ? "; the earlier movie and pictures are kept" : "");
    if (!kept)
      fmt::print("  movie     {}\n  pictures  {}\n", files.movie(request.movie).string(),
                 (files.frames() / "").string());
    if (whole) fmt::print("  report    {}\n", files.report().string());
  }
  return whole ? done : interrupted;
}

int compare_scene(const Request& request) {
  const std::string& scene = request.what.front();
  const fs::path folder =
      request.folder.empty() ? fs::path("out") / (fs::path(scene).stem().string() + "-compare") : request.folder;
  const auto runs = plan(scene, request.vary, request.settings, folder);
  const render::Look look = with_size(runs.front().scene.look, request.size);
  check_pictures(request, look);
  std::vector<ShownRun> folders;
  for (const PlannedRun& run : runs) folders.push_back({run.label, run.folder});
  const FolderLock lock(folder);
  check_folder(folder, folders, request.overwrite);
  if (!request.overwrite) std::for_each(runs.begin(), runs.end(), check_kept);

  const Stopwatch watch;
  const SignalWatch signals;
  // Tells that the folder is a comparison's; of pictures that are there, the note is theirs.
  if (!is_drawn(folder)) write_note(folder, folders);
  ProgressTable table(Progress::suitable(request.quiet));
  const int threads = request.threads > 0 ? request.threads : omp_get_num_procs();
  const Outcome outcome = run_all(runs, threads, request.overwrite, table, [&] { return signals.caught(); });
  for (const std::string& error : outcome.errors) fmt::print(stderr, "seiche: {}\n", error);
  if (outcome.interrupted) {
    if (!request.quiet)
      fmt::print("Interrupted after {}; what is done is kept for the next time\n", clock_text(watch.seconds()));
    return interrupted;
  }
  std::vector<ComparedRun> shown;
  for (const PlannedRun& run : runs) {
    try {
      shown.push_back(compared(run.label, read_run(run.folder)));
    } catch (const BadFolder&) {
      if (outcome.errors.empty()) throw;  // else it has been told why it isn't there
    }
  }
  if (shown.empty()) return failed;
  const int code = show(request, shown, look, folder, signals, watch);
  return code == done && !outcome.errors.empty() ? failed : code;
}

// Names that tell the runs apart: by what differs in their scenes if that is little, else by their folders.
std::vector<std::string> names_of(const std::vector<StoredRun>& runs) {
  constexpr std::size_t little = 3;
  std::vector<const Scene*> scenes;
  for (const StoredRun& run : runs) scenes.push_back(&run.scene);
  const auto keys = differences(scenes);
  auto labels = labels_of(scenes, keys);
  std::vector<std::string> folders, paths;
  for (const StoredRun& run : runs) {
    folders.push_back(fs::absolute(run.folder).lexically_normal().filename().string());
    paths.push_back(run.folder.string());
  }
  const auto differ = [&](const std::vector<std::string>& names) {
    return std::set<std::string>(names.begin(), names.end()).size() == names.size();
  };
  if (!keys.empty() && keys.size() <= little && differ(labels)) return labels;
  return differ(folders) ? folders : paths;
}

// Keys of the picture may be set anew; the rest of a run that is done can't be.
render::Look look_of(const Request& request, const StoredRun& first) {
  Scene scene = first.scene;
  const Settings settings = override_settings(request.settings);
  for (const Complaint& complaint : settings.complaints) throw std::invalid_argument(complaint.message);
  for (const Setting& setting : settings.good) {
    if (setting.option->section != "look")
      throw std::invalid_argument(
          fmt::format("{}: these runs are done; only keys of [look] can be set", setting.origin));
    if (const auto complaint = assign(*setting.option, scene, setting.value))
      throw std::invalid_argument(fmt::format("{}: {}", setting.origin, *complaint));
  }
  if (!settings.lists.empty())
    throw std::invalid_argument("a list can't be set for runs that are done; only keys of [look] can be");
  return with_size(scene.look, request.size);
}

// Two at least, each another one.
void check_folders(const std::vector<std::string>& folders) {
  if (folders.size() < 2)
    throw std::invalid_argument(fmt::format(
        "{} alone can't be compared; give two or more folders of runs, or a scene with --vary", folders.front()));
  std::error_code missing;  // read_run tells it better
  for (std::size_t k = 0; k < folders.size(); ++k)
    for (std::size_t i = 0; i < k; ++i)
      if (fs::equivalent(folders[i], folders[k], missing))
        throw std::invalid_argument(
            fmt::format("{} and {} are the same folder; leave one out", folders[i], folders[k]));
  if (folders.size() > render::most_panels)
    throw std::invalid_argument(
        fmt::format("{} runs are too many; a picture has room for {}", folders.size(), render::most_panels));
}

int compare_folders(const Request& request) {
  if (!request.vary.empty())
    throw std::invalid_argument(
        fmt::format("--vary {}: these runs are done; give a scene to vary it", request.vary.front()));
  check_folders(request.what);
  std::vector<StoredRun> stored;
  for (const std::string& folder : request.what) stored.push_back(read_run(folder));
  const render::Look look = look_of(request, stored.front());
  const auto labels = names_of(stored);
  std::vector<ComparedRun> runs;
  std::vector<ShownRun> folders;
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (stored[i].info.dimension != stored.front().info.dimension)
      throw std::invalid_argument(fmt::format("{} is a {}-D run and {} a {}-D one; they can't share a picture",
                                              request.what[i], stored[i].info.dimension, request.what.front(),
                                              stored.front().info.dimension));
    runs.push_back(compared(labels[i], std::move(stored[i])));
    folders.push_back({labels[i], runs.back().run.folder});
  }
  clock_of(runs);  // throws where they can't share one
  check_pictures(request, look);
  const fs::path folder = request.folder.empty() ? "out/compare" : request.folder;
  const FolderLock lock(folder);
  check_folder(folder, folders, request.overwrite);
  const Stopwatch watch;
  const SignalWatch signals;
  if (!is_drawn(folder)) write_note(folder, folders);
  return show(request, runs, look, folder, signals, watch);
}

}  // namespace

int compare(const Request& request) {
  if (request.what.empty())
    throw std::invalid_argument("nothing to compare; give a scene with --vary, or two or more folders of runs");
  if (fs::is_directory(request.what.front())) return compare_folders(request);
  if (request.what.size() > 1)
    throw std::invalid_argument(fmt::format(
        "{} is not the folder of a run; give one scene with --vary, or folders of runs alone", request.what.front()));
  if (request.vary.empty())
    throw std::invalid_argument("nothing varies; give --vary KEY=VALUE,VALUE, as in --vary method.kernel=KF1,KF3");
  return compare_scene(request);
}

}  // namespace seiche::apps::compare
