#pragma once
#include <string>
#include <vector>

#include "solver/column.hpp"
#include "solver/frame.hpp"
#include "solver/surface_mesh.hpp"

namespace seiche {

/// What every frame of a run has in common; known before the first step.
struct RunInfo {
  std::string name;     ///< the scene's, as in "pan2008"
  std::string version;  ///< the program's, as in "0.1.0"
  std::string scene_hash;
  std::string parameters;  ///< every scene key with its value, as TOML text
  std::string kernel;      ///< as in "KF3"
  std::string preset;
  int dimension = 2;
  SurfaceMesh tank{};  ///< inner surface of its wall, in its frame
  bool closed = true;
  double depth = 0;             ///< of the still liquid [m]
  double density = 0;           ///< [kg/m^3]
  double gravity = 0;           ///< its size [m/s^2]
  double pull = 0;              ///< gravity, or the tank's greatest acceleration where that is more [m/s^2]
  double spacing = 0;           ///< l0 [m]
  Double3 excursion{};          ///< greatest displacement of any point of the tank on each axis [m]
  double frame_interval = 0;    ///< [s]
  double end = 0;               ///< [s]
  std::vector<Column> sensors;  ///< of Frame::readings
};

}  // namespace seiche
