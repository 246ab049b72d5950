#pragma once
#include <optional>
#include <string>

#include "apps/common/output_kinds.hpp"
#include "render/look.hpp"
#include "render/movie_format.hpp"
#include "solver/length_unit.hpp"
#include "solver/parameters.hpp"

namespace seiche::apps {

/// What a run writes beside run.json.
struct Output {
  WantedOutputs wanted{};
  render::MovieFormat movie = render::MovieFormat::mp4;
  double probe_rate = 1000;  ///< [Hz]
  double frame_rate = 50;    ///< pictures, movie frames and VTU files per simulated second [Hz]
};

/// One scene: what to simulate, what to write, how it looks. Every member but `name`, `file` and `parameters.threads`
/// is a key of a scene file, or of a list in it; option_table.cpp and list_table.cpp have them.
struct Scene {
  std::string name;  ///< the file's, without its ending
  std::string file;  ///< path as the user gave it
  Parameters parameters;
  /// What may be said otherwise in a scene file: parse_scene puts it into the parameters, and then it is as here.
  struct {
    double fill = 0;                   ///< share of the tank's volume that is liquid
    double fill_height = 0;            ///< still level above the tank's lowest point, over the tank's height
    double volume = 0;                 ///< of the liquid [m^2 in 2-D, m^3]
    std::string file{};                ///< of the tank's points, or of its mesh: that stays here, and `unit`
    std::optional<LengthUnit> unit{};  ///< of the mesh's file
    std::string columns{};             ///< of the motion's file that are followed; that stays here, too
  } given{};
  Output output;
  render::Look look;

  bool writes(OutputKind kind) const {
    return kind == OutputKind::movie ? output.movie != render::MovieFormat::none : output.wanted[kind];
  }
  bool draws() const { return writes(OutputKind::pictures) || writes(OutputKind::movie); }

  /// Whether anything needs sensor readings.
  bool samples() const { return writes(OutputKind::probes) || (draws() && look.draws_curves()); }
};

}  // namespace seiche::apps
