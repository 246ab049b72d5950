#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/common/output_folder.hpp"

// The folder that a comparison goes to.
namespace seiche::apps::compare {

/// A run that a comparison shows.
struct ShownRun {
  std::string label;
  std::filesystem::path folder;
};

/// The comparison's movie, pictures and page.
OutputFolder files_in(const std::filesystem::path& folder);

/// While one lives, no other comparison is made in its folder; nor while a process is left that was started meanwhile.
class FolderLock {
 public:
  /// Makes the folder if need be. Throws BadFolder where it can't be made, or another has locked it.
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_ = -1;
};

/// Whether a comparison's pictures are in the folder.
bool is_drawn(const std::filesystem::path& folder);

/// Throws BadFolder for the folder of a run and, unless they may be overwritten, for other files and for
/// pictures of a comparison of others than these. Writes nothing.
void check_folder(const std::filesystem::path& folder, const std::vector<ShownRun>& runs, bool overwrite);

/// Writes compare.json, which tells what check_folder asks for. Throws std::runtime_error.
void write_note(const std::filesystem::path& folder, const std::vector<ShownRun>& runs);

/// Where a comparison is drawn, so that the one before it stays until this one is whole.
class Draft {
 public:
  explicit Draft(const std::filesystem::path& folder);
  ~Draft();  ///< removes what wasn't published
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  const OutputFolder& files() const { return draft_; }

  /// Puts what has been drawn in the place of what was there before. Throws std::runtime_error.
  void publish();

 private:
  OutputFolder final_, draft_;
};

}  // namespace seiche::apps::compare
