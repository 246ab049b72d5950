#include "apps/validate/page.hpp"

#include <algorithm>

namespace seiche::apps::validate {

render::Image draw_page(const std::vector<Chart>& charts) {
  constexpr int columns = 2, width = 1200, height = 640;
  const int rows = (static_cast<int>(charts.size()) + columns - 1) / columns;
  render::Image page{columns * width, rows * height, {}};
  page.rgba.assign(std::size_t{4} * page.width * page.height, 255);
  for (std::size_t n = 0; n < charts.size(); ++n) {
    const Chart& chart = charts[n];
    const render::Image part =
        render::draw_curves(chart.curves, chart.title, chart.x_label, chart.y_label, width, height, chart.scales);
    const std::size_t left = n % columns * width, top = n / columns * height;
    for (std::size_t row = 0; row < height; ++row)
      std::copy_n(part.rgba.begin() + 4 * row * width, 4 * width,
                  page.rgba.begin() + 4 * ((top + row) * page.width + left));
  }
  return page;
}

}  // namespace seiche::apps::validate
