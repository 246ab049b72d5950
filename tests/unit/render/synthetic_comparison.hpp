#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "render/panels/comparison.hpp"
#include "tests/unit/render/synthetic_curves.hpp"

namespace seiche::test {

/// Runs in the synthetic tank; all go on but the second, which fails at 1.2 s.
inline std::vector<render::Variant> variants(const Box& box, std::size_t count) {
  std::vector<render::Variant> all;
  for (std::size_t i = 0; i < count; ++i) {
    render::Variant one{run_with_sensors(box), "KF" + std::to_string(i + 1), {}, i == 1};
    one.run.kernel = one.label;
    if (one.failed) one.message = {"stopped at 1.216 s", "61 of 1200 fluid particles leaked through the walls"};
    all.push_back(std::move(one));
  }
  return all;
}

constexpr double failure = 1.2;  ///< time of the last frame of the run that fails [s]

/// Their picture at a time, their readings scaled so that each has curves of its own.
inline render::Image draw_comparison(const render::Look& look, const Box& box, std::size_t count, double time) {
  render::Comparison comparison(variants(box, count), look);
  std::vector<render::PanelFrame> frames;
  for (std::size_t i = 0; i < count; ++i) {
    const double last = i == 1 ? failure : 10;
    Readings mine = readings(0, last);
    for (std::size_t k = 0; k < mine.values.size(); ++k) mine.values[k] *= 1 - 0.07 * static_cast<double>(i);
    comparison.record(i, mine);
    const double shown = std::min(time, last);
    frames.push_back(
        {lattice(box, 0.2 * std::sin(6.28 * shown) / static_cast<double>(i + 1), std::lround(shown / 0.02)),
         time > last});
  }
  return comparison.draw(time, frames, {0, 3000});
}

}  // namespace seiche::test
