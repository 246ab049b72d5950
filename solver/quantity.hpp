#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "solver/choice.hpp"
#include "solver/frame.hpp"
#include "solver/run_info.hpp"

// What a frame tells of each particle. Scene keys, colours, their range and title, and VTU arrays read the table.
namespace seiche {

enum class Quantity { pressure, speed, number_density, free_surface, kind, vorticity };

struct QuantityRow : Choice<Quantity> {
  std::string_view title;
  std::string_view unit;  ///< empty: none
  /// Of a particle, by its place in the frame [unit]; of a quantity with classes, their number. Null: the solver
  /// derives it when it makes the frame, and it is in Frame::derived.
  double (*of)(const Frame& frame, std::size_t particle);
  /// Least and greatest value that most scenes keep to, known before the first step [unit].
  std::array<double, 2> (*usual)(const RunInfo& run);
};

template <>
struct ChoiceTable<Quantity> {
  // a H, the square of a long wave's speed under the greatest pull [m^2/s^2]; 1 where nothing pulls.
  static double wave(const RunInfo& run) { return run.pull > 0 ? run.pull * run.depth : 1; }

  static constexpr std::array rows{
      QuantityRow{{Quantity::pressure, "pressure", "gauge"},
                  "pressure",
                  "Pa",
                  [](const Frame& frame, std::size_t i) -> double { return frame.pressure[i]; },
                  [](const RunInfo& run) {
                    return std::array{0.0, 1.5 * run.density * wave(run)};
                  }},
      QuantityRow{{Quantity::speed, "speed", "relative to the tank"},
                  "speed",
                  "m/s",
                  [](const Frame& frame, std::size_t i) {
                    const double x = frame.velocity[i][0], y = frame.velocity[i][1], z = frame.velocity[i][2];
                    return std::sqrt(x * x + y * y + z * z);
                  },
                  // Half of what a long wave travels at: only waves that break go beyond.
                  [](const RunInfo& run) {
                    return std::array{0.0, 0.5 * std::sqrt(wave(run))};
                  }},
      QuantityRow{{Quantity::number_density, "number-density", "equation (3), over its value on the initial lattice"},
                  "number density n/n\u2080",
                  "",
                  [](const Frame& frame, std::size_t i) -> double { return frame.number_density[i]; },
                  // Its ideal in the middle, for diverging colours.
                  [](const RunInfo&) {
                    return std::array{0.8, 1.2};
                  }},
      QuantityRow{{Quantity::free_surface, "free-surface", "whether a particle is at it"},
                  "particles",
                  "",
                  [](const Frame& frame, std::size_t i) { return frame.free_surface[i] ? 1.0 : 0.0; },
                  [](const RunInfo&) {
                    return std::array{0.0, 1.0};
                  }},
      QuantityRow{{Quantity::kind, "kind", "fluid, wall or dummy"},
                  "particles",
                  "",
                  [](const Frame& frame, std::size_t i) { return static_cast<double>(frame.kind[i]); },
                  [](const RunInfo&) {
                    return std::array{0.0, 2.0};
                  }},
      QuantityRow{{Quantity::vorticity, "vorticity", "positive anticlockwise, in 3-D its magnitude"},
                  "vorticity",
                  "1/s",
                  nullptr,
                  // That greatest speed, lost within half the depth.
                  [](const RunInfo& run) {
                    const double most = std::sqrt(wave(run)) / run.depth;
                    return std::array{run.dimension == 2 ? -most : 0.0, most};
                  }},
  };
};

constexpr const QuantityRow& row_of(Quantity quantity) {
  for (const QuantityRow& row : ChoiceTable<Quantity>::rows)
    if (row.value == quantity) return row;
  throw BadParameters("no row of this quantity");
}

}  // namespace seiche
