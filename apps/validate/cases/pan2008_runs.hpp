#pragma once
#include <map>
#include <string>
#include <vector>

#include "apps/validate/case.hpp"
#include "apps/validate/surface_flags.hpp"

// The runs of the case "pan2008", what they are held against, and how both are drawn.
namespace seiche::apps::validate::pan {

constexpr double cut = 10;  ///< noise is what lies above it [Hz]

/// Fully nonlinear potential theory.
struct References {
  Series left, right;                 ///< elevation [m]
  Series pressure;                    ///< at the left bottom corner [Pa]
  std::map<double, Series> profiles;  ///< by time [s]; z over x [m]
};

References read_references(const Bench& bench);

constexpr double frame_interval = 0.05;  ///< of the runs [s]

/// A run's sensors, with 60 wave gauges along the tank.
struct Run {
  Recording recording;
  SurfaceFlags flags;

  const Series& left() const { return recording.sensors.at("eta_left"); }
  const Series& right() const { return recording.sensors.at("eta_right"); }
  const Series& pressure() const { return recording.sensors.at("p_left_bottom"); }
  double spacing() const { return recording.parameters.particles.spacing; }
  double weight() const;  ///< rho g h, the corner's pressure at rest [Pa]
};

Run make_run(Bench& bench, double spacing, double end);

/// Adds how far another code is from the same theory, to judge the runs by.
/// @param weight rho g h [Pa]
void add_peer_figures(std::vector<Figure>& figures, const Bench& bench, const References& theory, double weight);

/// As in "2.5 mm".
std::string millimetres(double spacing);

/// Wall elevation, corner pressure, and the surface at 3 s.
std::vector<Chart> charts(const std::vector<Run>& runs, const References& theory);

}  // namespace seiche::apps::validate::pan
