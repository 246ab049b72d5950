#include "render/layout.hpp"

#include <algorithm>
#include <cmath>

namespace seiche::render {
namespace {

double font_height(int width, int height) {
  constexpr double of_720p = 21;
  const double across = width / 1280.0, up = height / 720.0;
  return std::max(9.0, of_720p * std::min({std::sqrt(across * up), 1.4 * across, 1.6 * up}));
}

// Two items at the ends of a row, or below each other where the row is too short.
struct Row {
  double left, right, room, font;
  double gap() const { return left > 0 && right > 0 ? 2 * font : 0; }
  bool stacked() const { return left + gap() + right > room; }
  double height() const {
    if (left <= 0 && right <= 0) return 0;
    return (stacked() && gap() > 0 ? 2.9 : 1.5) * font;
  }
  void place(double x, double top, Box& first, Box& second) const {
    first = {x, top - font, std::min(left, room), font};
    second = {stacked() ? x : x + room - right, stacked() && gap() > 0 ? top - 2.4 * font : top - font, right, font};
  }
};

Layout lay_out(const Needs& needs, bool upright) {
  Layout out;
  out.font = font_height(needs.width, needs.height);
  out.line = std::max(1.0, std::round(out.font / 10));
  out.bar_upright = upright;
  const double f = out.font;
  const bool bar = needs.bar_labels > 0;
  const double pad = 1.4 * f, gap = 0.8 * f;
  const double room_x = needs.width - 2 * pad, room_y = needs.height - 2 * pad;

  // Beside the tank: colours, ticks and labels under a title. Below it: title, colours, labels.
  const double bar_column = bar && upright ? 1.2 * f + std::max(needs.bar_title, 1.7 + needs.bar_labels) * f : 0;
  const double bar_row = bar && !upright ? 4.6 * f : 0;

  // The ruler's length depends on the scale and the scale on the rows' heights: the ruler is at most a fifth of the view.
  const double ruler_label = needs.ruler > 0 ? (needs.ruler_label + 0.6) * f : 0;
  const double longest_ruler = needs.ruler > 0 ? needs.ruler / needs.view_width * (room_x - bar_column) + ruler_label : 0;
  Row top{needs.caption * f, needs.clock * f, room_x, f}, bottom{longest_ruler, needs.key * f, room_x, f};
  const double room_view_y = room_y - top.height() - bottom.height() - bar_row;
  out.scale = std::min((room_x - bar_column) / needs.view_width, room_view_y / needs.view_height);

  out.view.width = needs.view_width * out.scale;
  out.view.height = needs.view_height * out.scale;
  const double block_width = out.view.width + bar_column;
  const double block_height = out.view.height + top.height() + bottom.height() + bar_row;
  double x = pad + (room_x - block_width) / 2;
  double y = pad + (room_y + block_height) / 2;

  // Rows are as wide as the tank with its bar; wider where their texts need it and the picture has room.
  const auto spread = [&](Row& row) {
    row.room = std::min(room_x, std::max(block_width, row.left + row.gap() + row.right));
    return pad + (room_x - row.room) / 2;
  };
  const double top_x = spread(top);
  top.place(top_x, y, out.caption, out.clock);
  y -= top.height();
  out.view.x = x;
  out.view.y = y - out.view.height;
  if (bar && upright) {
    const double title = 3 * f, below = 1.5 * f;  // the title stands on the upper triangle, which takes a line as well
    const double height = std::max(std::min(out.view.height, 24 * f) - title - below, 5 * f);
    out.bar = {out.view.right() + 1.2 * f, out.view.y + (out.view.height - height - title - below) / 2 + below, 0.9 * f, height};
  }
  y = out.view.y - 0.5 * f;
  const double ruler = needs.ruler * out.scale + ruler_label;
  bottom.left = needs.ruler > 0 ? ruler : 0;
  const double bottom_x = spread(bottom);
  bottom.place(bottom_x, y, out.ruler, out.key);
  y = out.view.y - bottom.height();
  if (bar && !upright) {
    const double width = std::min(room_x - 2 * (needs.bar_labels + 1.3) * f, 36 * f);
    out.bar = {x + (block_width - width) / 2, y - gap - 2.2 * f, width, 0.9 * f};
  }
  return out;
}

}  // namespace

Layout lay_out(const Needs& needs) {
  const Layout beside = lay_out(needs, true), below = lay_out(needs, false);
  return below.scale > beside.scale ? below : beside;
}

}  // namespace seiche::render
