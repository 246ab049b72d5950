#include "apps/compare/folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <nlohmann/json.hpp>

#include "apps/common/schema.hpp"
#include "apps/run/run_info.hpp"
#include "apps/run/stored_run.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps::compare {
namespace {

constexpr const char* name = "compare";  // of the movie, and of the file that tells such a folder
constexpr int note_schema = 1;
constexpr const char* ways_out = "choose another folder with -o DIR, or replace the comparison with --overwrite";

fs::path note_in(const fs::path& folder) { return folder / (std::string(name) + ".json"); }

// From the comparison's folder, so that both can be moved together, and by whatever way it was named.
std::string relative_path(const fs::path& run, const fs::path& folder) { return fs::proximate(run, folder).string(); }

// The runs that the folder's comparison shows.
std::vector<std::string> noted(const fs::path& folder) {
  try {
    std::vector<std::string> runs;
    const auto note = nlohmann::json::parse(render::read_file(note_in(folder)));
    check_schema(note, note_schema, ways_out);
    for (const auto& run : note.at("runs")) runs.push_back(run.at("folder"));
    return runs;
  } catch (const std::invalid_argument& error) {
    throw BadFolder(fmt::format("{} can't be used: {}", note_in(folder).string(), error.what()));
  } catch (const std::exception& error) {
    throw BadFolder(fmt::format("{} can't be used: {}; {}", note_in(folder).string(), error.what(), ways_out));
  }
}

}  // namespace

OutputFolder files_in(const fs::path& folder) { return {folder, name}; }

FolderLock::FolderLock(const fs::path& folder) {
  files_in(folder).check(true);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw BadFolder(fmt::format("can't make the folder {}: {}", folder.string(), error.message()));
  // Runs inherit it: where this program is killed, they hold the lock until they have ended.
  descriptor_ = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  // Another error than this one: the file system, as NFS, locks no folders.
  if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    close(descriptor_);
    throw BadFolder(
        fmt::format("another `seiche compare` is at work in {}; wait for it, or choose another folder with "
                    "-o DIR",
                    folder.string()));
  }
}

FolderLock::~FolderLock() { close(descriptor_); }

bool is_drawn(const fs::path& folder) { return !stored_pictures({folder, {}, {}, {}}).empty(); }

void check_folder(const fs::path& folder, const std::vector<ShownRun>& runs, bool overwrite) {
  if (fs::exists(files_in(folder).record()))
    throw BadFolder(fmt::format("{} is the folder of a run; choose another with -o DIR", folder.string()));
  const bool again = fs::exists(note_in(folder));
  files_in(folder).check(overwrite || again);
  if (overwrite || !again || !is_drawn(folder)) return;
  const auto earlier = noted(folder);
  const auto is_shown = [&](const std::string& run) {
    return std::any_of(runs.begin(), runs.end(),
                       [&](const ShownRun& p) { return relative_path(p.folder, folder) == run; });
  };
  // More runs than before are fine: nothing is lost then.
  if (!std::all_of(earlier.begin(), earlier.end(), is_shown))
    throw BadFolder(fmt::format("{} holds a comparison of other runs: {}; {}", folder.string(),
                                fmt::join(earlier, ", "), ways_out));
}

void write_note(const fs::path& folder, const std::vector<ShownRun>& runs) {
  nlohmann::ordered_json json{
      {"seiche", version()}, {schema_key, note_schema}, {"runs", nlohmann::ordered_json::array()}};
  for (const ShownRun& run : runs)
    json["runs"].push_back({{"label", run.label}, {"folder", relative_path(run.folder, folder)}});
  render::write_file(note_in(folder), json.dump(2) + "\n");
}

Draft::Draft(const fs::path& folder) : final_(files_in(folder)), draft_(files_in(render::partial_name(folder / name))) {
  fs::remove_all(draft_.path);  // of one that was killed
}

Draft::~Draft() {
  std::error_code ignored;
  fs::remove_all(draft_.path, ignored);
}

void Draft::publish() {
  final_.prepare();
  std::vector<fs::path> drawn;
  for (const auto& entry : fs::recursive_directory_iterator(draft_.path))
    if (!entry.is_directory()) drawn.push_back(entry.path().lexically_relative(draft_.path));
  for (const fs::path& file : drawn) {
    fs::create_directories((final_.path / file).parent_path());
    fs::rename(draft_.path / file, final_.path / file);
  }
}

}  // namespace seiche::apps::compare
