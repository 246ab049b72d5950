#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "apps/validate/case.hpp"
#include "apps/validate/known_misses.hpp"

namespace seiche::apps::validate {

/// What the command line of `seiche validate` asks for.
struct Request {
  std::filesystem::path scenes;  ///< empty: find_scenes()
  std::filesystem::path folder = "out/validate";
  std::vector<std::string> only;  ///< names of cases; empty: all
  int threads = 0;                ///< 0: one per core
  bool quick = false;
  bool list = false;
  bool overwrite = false;
};

/// Folder of the program's own scenes: share/seiche/scenes beside the bin/ that it is installed in, else scenes/ of the
/// build.
std::filesystem::path find_scenes();

/// `seiche validate`: runs the cases asked for, prints their figures, and writes table.md, table.csv and figures.png
/// into the folder. Returns what the program exits with: 130 when it was interrupted, 1 if a case failed, 3 if a figure
/// misses its target and that isn't a known miss, 0 else. The files hold what was found until then.
/// Throws std::invalid_argument for a case or a folder that isn't there, BadFolder, render::NoGl.
int validate(const Request& request, const std::vector<Case>& cases, const std::vector<KnownMissOf>& known);

}  // namespace seiche::apps::validate
