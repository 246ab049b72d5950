#pragma once
#include <string>

#include "render/look.hpp"
#include "solver/parameters.hpp"

namespace seiche::apps {

/// What a run writes beside run.json.
struct Output {
  bool pictures = true;
  std::string movie = "mp4";  ///< mp4 | webm | gif | none
  bool vtu = true;
  bool probes = true;
  bool report = true;        ///< report.html
  double probe_rate = 1000;  ///< [Hz]
  double frame_rate = 50;    ///< pictures, movie frames and VTU files per simulated second [Hz]
};

/// One scene: what to simulate, what to write, how it looks. Every member but `name`, `file` and `parameters.threads`
/// is a key of a scene file, or of a list in it; option_table.cpp and list_table.cpp have them.
struct Scene {
  std::string name;  ///< the file's, without its ending
  std::string file;  ///< path as the user gave it
  Parameters parameters;
  Output output;
  render::Look look;

  bool draws() const { return output.pictures || output.movie != "none"; }

  /// Whether anything needs sensor readings.
  bool samples() const { return output.probes || (draws() && look.curves != "none"); }
};

}  // namespace seiche::apps
