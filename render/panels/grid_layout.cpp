#include "render/panels/grid_layout.hpp"

#include <algorithm>
#include <cmath>

#include "render/picture/layout.hpp"

namespace seiche::render {
namespace {

// In font heights: a label with the gap below it, and gaps between panels.
constexpr double smaller_font = 0.7;  // than in a picture of one run
constexpr double plots[] = {0.17, 0.21, 0.25};
constexpr double head = 1.6, between_across = 1.2, between_up = 0.7, beside_label = 0.8;

struct Grid {
  std::size_t columns, rows;
};

Layout lay_out_around(Needs needs, Grid grid) {
  const auto columns = static_cast<double>(grid.columns), rows = static_cast<double>(grid.rows);
  needs.font = smaller_font;
  needs.view_width *= columns;
  needs.view_height *= rows;
  needs.gaps_across = (columns - 1) * between_across;
  needs.gaps_up = rows * head + (rows - 1) * between_up;
  return lay_out(needs);
}

PanelBoxes panel_at(const Needs& needs, const Layout& around, std::size_t column, std::size_t row) {
  const double f = around.font, width = needs.view_width * around.scale, height = needs.view_height * around.scale;
  const double x = around.view.x + static_cast<double>(column) * (width + between_across * f);
  const double top = around.view.top() - static_cast<double>(row) * (height + (head + between_up) * f);
  PanelBoxes place;
  place.view = {std::round(x), std::round(top - head * f - height), std::floor(width), std::floor(height)};
  place.label = {place.view.x, place.view.top() + (head - 1) / 2 * f, place.view.width, f};
  return place;
}

// Notes stand at the right, above the panels whose labels leave room for them.
void place_notes(GridLayout& grid, const std::vector<PanelNeeds>& panels) {
  const double f = grid.around.font;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    Box &label = grid.panels[i].label, &note = grid.panels[i].note;
    if ((panels[i].label + panels[i].note + beside_label) * f > label.width) continue;
    note = label;
    note.width = panels[i].note * f;
    note.x = label.right() - note.width;
    label.width = panels[i].label * f;
  }
}

}  // namespace

GridLayout lay_out_grid(const Needs& picture, const std::vector<PanelNeeds>& panels) {
  Needs needs = picture;
  needs.plot = plots[0];
  GridLayout best;
  Grid shape{1, 1};
  for (std::size_t columns = 1; columns <= panels.size(); ++columns) {
    const Grid grid{columns, (panels.size() + columns - 1) / columns};
    Layout around = lay_out_around(needs, grid);
    if (columns > 1 && around.scale <= best.around.scale) continue;
    best.around = std::move(around);
    shape = grid;
  }
  for (const double plot : plots) {  // higher where that takes nothing from the panels
    Needs higher = needs;
    higher.plot = plot;
    Layout around = lay_out_around(higher, shape);
    if (around.scale < best.around.scale) break;
    best.around = std::move(around);
  }
  for (std::size_t i = 0; i < panels.size(); ++i)
    best.panels.push_back(panel_at(needs, best.around, i % shape.columns, i / shape.columns));
  place_notes(best, panels);
  return best;
}

}  // namespace seiche::render
