#pragma once
#include <optional>
#include <string>
#include <vector>

#include "apps/validate/case.hpp"

// What cases of tanks share: a tank at rest, and its liquid's first wave.
namespace seiche::apps::validate {

/// A tank, and what is asked of it.
struct Asked {
  std::string title;
  std::string scene;
  std::vector<std::string> settings;
  double error, speed;                   ///< at rest, at most [%, mm/s]
  std::optional<double> rms_speed = {};  ///< at rest, at most [mm/s]; none: it isn't asked for
  std::optional<double> level = {};      ///< volume below the surface, change within [%]
  std::optional<double> period = {};     ///< within [%]; none: it isn't timed
  double scale = 1;                      ///< its length over that of the others, about 0.5 m
  bool in_quick = false;
  double still_end = 5, swing_end = 11;  ///< of its runs [s]
};

/// At rest to `still_end`, in the quick validation to 2 s: pressure, speeds, level, and what has leaked. By Froude's
/// law times and speeds of a larger tank are divided by the square root of its scale.
void rest(Bench& bench, const Asked& tank, std::vector<Figure>& figures);

/// After a push of 4 mm within 0.4 s the tank stands, and the liquid's centre of mass swings with the first wave: its
/// period less that of the scene's natural modes. Adds a curve of it.
void swing(Bench& bench, const Asked& tank, Findings& found, Chart& chart);

/// Each at rest, and swinging where it is timed; in the quick validation those that it has, at rest.
Findings rest_and_swing(Bench& bench, const std::vector<Asked>& tanks, const std::string& chart_title);

}  // namespace seiche::apps::validate
