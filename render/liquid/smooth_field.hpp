#pragma once
#include <cstddef>
#include <vector>

#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// The liquid of a 2-D frame as fields on a grid that stands in the tank: the volume fraction of its fluid particles,
/// and the mean of a quantity. Each particle counts with a bell of radius 2.2 l0, over the part of such a bell that
/// lies inside the tank.
class SmoothField {
 public:
  /// `step`: the grid's, at most, but for a fraction of a pixel [m]. An open tank's grid goes on above its rim.
  SmoothField(const RunInfo& run, double step);

  void take(const Frame& frame, Quantity quantity);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  double left() const { return left_; }      ///< x of the first column [m]
  double bottom() const { return bottom_; }  ///< y of the first row [m]
  double dx() const { return dx_; }          ///< between columns [m]
  double dy() const { return dy_; }          ///< between rows [m]

  /// Row by row from the floor: 1 in the liquid, 0.5 at its surface.
  const std::vector<float>& fraction() const { return fraction_; }
  /// Means over the particles near by; 0 where there are none.
  const std::vector<float>& mean() const { return mean_; }

  /// The fraction at a point; 0 outside of the grid.
  double fraction_at(double x, double y) const;

  static constexpr double surface = 0.5;  ///< the fraction at the free surface

 private:
  /// Adds a volume [m^2] with its bell, unscaled.
  void splat(double x, double y, double volume, double value);

  double left_, bottom_, length_, height_, reach_;
  double volume_ = 0;  ///< of a particle, over the bell's integral [-]
  std::size_t columns_, rows_;
  double dx_, dy_;
  std::vector<float> fraction_, mean_;
  std::vector<float> open_;  ///< one over the share of each node's bell inside the tank; 0 where that is nothing
};

}  // namespace seiche::render
