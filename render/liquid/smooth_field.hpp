#pragma once
#include <cstddef>
#include <vector>

#include "render/picture/quantity.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

namespace seiche::render {

/// The liquid of a 2-D frame as fields on a grid that stands in the tank: the volume fraction of its fluid particles,
/// and the mean of a quantity. Each particle counts with a bell of radius 2.2 l0; the tank's sides are mirrors.
class SmoothField {
 public:
  /// `step`: the grid's, at most, but for a fraction of a pixel [m]. An open tank's grid goes on above its rim.
  SmoothField(const RunInfo& run, double step);

  void take(const Frame& frame, Quantity quantity);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  double dx() const { return dx_; }  ///< between columns; the first is at x = 0 [m]
  double dy() const { return dy_; }  ///< between rows; the first is at y = 0 [m]

  /// Row by row from the floor: 1 in the liquid, 0.5 at its surface.
  const std::vector<float>& fraction() const { return fraction_; }
  /// Means over the particles near by; 0 where there are none.
  const std::vector<float>& mean() const { return mean_; }

  /// The fraction at a point; 0 outside of the grid.
  double fraction_at(double x, double y) const;

  static constexpr double surface = 0.5;  ///< the fraction at the free surface

 private:
  void splat(double x, double y, double value);

  double length_, height_, reach_, volume_;
  bool closed_;
  std::size_t columns_, rows_;
  double dx_, dy_;
  std::vector<float> fraction_, mean_;
};

}  // namespace seiche::render
