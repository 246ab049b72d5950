#include "apps/common/output_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <vector>

#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

// Whether `name` is prefix + at least six digits + suffix, as frames are numbered.
bool is_numbered(const std::string& name, const std::string& prefix, const std::string& suffix) {
  const std::size_t ends = prefix.size() + suffix.size();
  if (name.size() < ends + 6 || !name.starts_with(prefix) || !name.ends_with(suffix)) return false;
  return std::all_of(name.begin() + prefix.size(), name.end() - suffix.size(),
                     [](unsigned char c) { return isdigit(c); });
}

// A file, and what a killed run may have left of it under its partial name.
void remove_file(const fs::path& file) {
  fs::remove(file);
  fs::remove(render::partial_name(file));
}

// Removes the numbered files, and the folder with them if nothing else is in it.
void remove_series(const fs::path& folder, const std::string& prefix, const std::string& suffix) {
  if (!fs::is_directory(folder)) return;
  const std::string partial = render::partial_name(prefix);
  std::vector<fs::path> doomed;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (is_numbered(name, prefix, suffix) || is_numbered(name, partial, suffix)) doomed.push_back(entry.path());
  }
  for (const fs::path& file : doomed) fs::remove(file);
  if (fs::is_empty(folder)) fs::remove(folder);
}

// What a run of the scene may have left of one kind of output.
void remove_output(const fs::path& run, const std::string& scene, const OutputRow& row) {
  for (const OutputFile& each : row.files) {
    const std::string name = fmt::format(fmt::runtime(each.name), scene);
    if (each.numbered)
      remove_series(run / each.folder, name, each.suffix);
    else
      remove_file(run / each.folder / (name + each.suffix));
  }
}

void check_folder(const fs::path& path, bool overwrite, const std::string& what) {
  if (!fs::exists(path)) return;
  if (!fs::is_directory(path)) {
    throw BadFolder(fmt::format("{} is a file, not a folder; choose another with -o DIR", path.string()));
  }
  if (!overwrite && !fs::is_empty(path)) {
    throw BadFolder(
        fmt::format("{} exists and isn't empty; choose another folder with -o DIR, or replace {} in it with "
                    "--overwrite",
                    path.string(), what));
  }
}

BadFolder cannot_prepare(const fs::path& path, const fs::filesystem_error& error) {
  return BadFolder(fmt::format("can't prepare the output folder {}: {}", path.string(), error.code().message()));
}

// What PictureFolder is made of, and the folder if nothing else is in it.
void remove_pictures(const PictureFolder& folder) {
  if (!fs::is_directory(folder.path)) return;
  remove_output(folder.path, folder.scene, output_row(OutputKind::movie));
  remove_series(folder.path, "", ".png");
}

}  // namespace

void OutputFolder::check(bool overwrite) const { check_folder(path, overwrite, "the run"); }

void OutputFolder::prepare() const {
  try {
    fs::create_directories(path);
    for (const OutputRow& row : output_rows()) remove_output(path, scene, row);
    remove_pictures({drawn_again(), scene});
    remove_file(record());
    remove_file(samples());
  } catch (const fs::filesystem_error& error) {
    throw cannot_prepare(path, error);
  }
}

fs::path OutputFolder::place(OutputKind kind) const {
  for (const OutputFile& each : output_row(kind).files) {
    const std::string name = fmt::format(fmt::runtime(each.name), scene);
    fs::path file = each.numbered ? path / each.folder / "" : path / each.folder / (name + each.suffix);
    if (fs::exists(file)) return file;
  }
  return {};
}

void PictureFolder::check(bool overwrite) const { check_folder(path, overwrite, "the pictures"); }

void PictureFolder::prepare() const {
  try {
    remove_pictures(*this);
    fs::create_directories(path);
  } catch (const fs::filesystem_error& error) {
    throw cannot_prepare(path, error);
  }
}

}  // namespace seiche::apps
