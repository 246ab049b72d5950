#pragma once
#include <filesystem>
#include <string>

#include "apps/common/errors.hpp"
#include "apps/common/output_kinds.hpp"
#include "render/movie_format.hpp"

namespace seiche::apps {

/// Where everything of a run goes.
struct OutputFolder {
  std::filesystem::path path;
  std::string scene;  ///< its name, which the movie, the .pvd and the .vtu files bear

  std::filesystem::path frames() const { return path / "frames"; }
  std::filesystem::path movie(render::MovieFormat format) const {
    return path / (scene + std::string(render::row_of(format).suffix));
  }
  std::filesystem::path pvd() const { return path / (scene + ".pvd"); }
  std::filesystem::path probes() const { return path / "probes.csv"; }
  std::filesystem::path record() const { return path / "run.json"; }
  std::filesystem::path report() const { return path / "report.html"; }
  std::filesystem::path samples() const { return path / "samples.json"; }
  std::filesystem::path drawn_again() const { return path / "render"; }  ///< a PictureFolder, if -o says nothing else

  /// The first of the kind's files that is there, or the folder of a series; empty without one.
  std::filesystem::path place(OutputKind kind) const;

  /// Throws BadFolder where a file stands in the way, or files do and may not be overwritten. Writes nothing.
  void check(bool overwrite) const;

  /// Makes the folder, and takes out what an earlier run of this scene wrote there; all other files stay.
  void prepare() const;
};

/// Where a run that is drawn again goes: 000123.png and a movie.
struct PictureFolder {
  std::filesystem::path path;
  std::string scene;  ///< its name, which the movie bears

  std::filesystem::path movie(render::MovieFormat format) const {
    return path / (scene + std::string(render::row_of(format).suffix));
  }

  /// As OutputFolder's.
  void check(bool overwrite) const;
  void prepare() const;
};

}  // namespace seiche::apps
