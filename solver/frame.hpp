#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "solver/rigid_state.hpp"

// The seam between the solver and everything that shows or stores its results. No VTK here, nothing of the solver.
namespace seiche {

enum class Kind : std::uint8_t { fluid = 0, wall = 1, dummy = 2 };

using Float3 = std::array<float, 3>;
using Double3 = std::array<double, 3>;

/// Sensor readings taken since the frame before, at the sensors' own sample times.
struct Readings {
  std::vector<double> time;    ///< [s], one entry per row
  std::vector<double> values;  ///< row by row, one entry per column of RunInfo::sensors
};

enum class Quantity;  // quantity.hpp

/// Of each particle, what the solver derives from the state when it makes a frame and no step needs.
struct DerivedField {
  Quantity quantity;
  std::vector<float> values;  ///< in the unit of the quantity's row
};

/// One instant of a run. Particle arrays are in id order and of equal length.
/// Axes: x along the tank from its left wall, y up from its floor, z across from its near wall (0 in 2-D).
struct Frame {
  long index = 0;   ///< frame number: time = index * RunInfo::frame_interval, but for a last frame cut short
  long step = 0;    ///< solver steps taken so far
  double time = 0;  ///< [s]
  RigidState pose;  ///< of the tank
  std::vector<Float3> position;       ///< in the tank's frame [m]
  std::vector<Float3> velocity;       ///< relative to the tank [m/s]
  std::vector<float> pressure;        ///< gauge [Pa]
  std::vector<float> number_density;  ///< n_i / n0 of equation (3) [-]
  std::vector<Kind> kind;
  std::vector<std::uint8_t> free_surface;  ///< 1 where equation (11) holds
  std::vector<std::uint32_t> id;
  std::vector<DerivedField> derived;  ///< empty in files of versions that had none
  Readings readings;

  std::size_t size() const { return position.size(); }
};

using FramePtr = std::shared_ptr<const Frame>;

}  // namespace seiche
