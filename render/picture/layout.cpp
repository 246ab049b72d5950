#include "render/picture/layout.hpp"

#include <algorithm>
#include <cmath>

#include "render/picture/curve_layout.hpp"
#include "render/picture/row.hpp"

namespace seiche::render {

double font_height(const Needs& needs) {
  constexpr double of_720p = 21;
  const double across = needs.width / 1280.0, up = needs.height / 720.0;
  return std::max(9.0, needs.font * of_720p * std::min({std::sqrt(across * up), 1.4 * across, 1.6 * up}));
}

namespace {

// Beside the tank: colours, ticks and labels under a title. Below it: title, colours, labels. Sizes in font heights.
struct BarRoom {
  double across = 0, up = 0;
  BarRoom(const Needs& needs, bool upright) {
    if (needs.bar_labels <= 0) return;
    if (upright)
      across = 1.2 + std::max(needs.bar_title, 1.7 + needs.bar_labels);
    else
      up = 4.6;
  }
};

Box upright_bar(const Box& view, double f) {
  const double title = 3 * f, below = 1.5 * f;  // the title stands on the upper triangle, which takes a line as well
  const double height = std::max(std::min(view.height, 24 * f) - title - below, 5 * f);
  return {view.right() + 1.2 * f, view.y + (view.height - height - title - below) / 2 + below, 0.9 * f, height};
}

// `floor`: height of what lies below [pixels].
Layout lay_out(const Needs& needs, double floor, bool upright) {
  Layout out;
  const double f = out.font = font_height(needs);
  out.line = std::max(1.0, std::round(f / 10));
  out.bar_upright = upright;
  const BarRoom bar(needs, upright);
  const double pad = layout_pad * f, room_x = needs.width - 2 * pad, room_y = needs.height - floor - 2 * pad;
  const double room_view_x = room_x - (bar.across + needs.gaps_across) * f;

  // The ruler's length depends on the scale and the scale on the rows' heights: what it can be at most is reserved.
  const double ruler_label = needs.ruler > 0 ? (needs.ruler_label + 0.6) * f : 0;
  const double longest_ruler = needs.ruler / needs.view_width * room_view_x + ruler_label;
  Row top{needs.caption * f, needs.clock * f, room_x, f}, bottom{longest_ruler, needs.key * f, room_x, f};
  const double rows = top.height() + bottom.height() + (bar.up + needs.gaps_up) * f;
  out.scale = std::min(room_view_x / needs.view_width, (room_y - rows) / needs.view_height);
  out.view.width = needs.view_width * out.scale + needs.gaps_across * f;
  out.view.height = needs.view_height * out.scale + needs.gaps_up * f;

  const double block = out.view.width + bar.across * f;
  const double top_edge = floor + pad + (room_y + out.view.height + rows - needs.gaps_up * f) / 2;
  out.view.x = pad + (room_x - block) / 2;
  out.view.y = top_edge - top.height() - out.view.height;

  // Rows are as wide as the tank with its bar; wider where their texts need it and the picture has room.
  const auto left_edge = [&](Row& row) {
    row.room = std::min(room_x, std::max(block, row.left + row.gap() + row.right));
    return pad + (room_x - row.room) / 2;
  };
  const double top_x = left_edge(top);
  top.place(top_x, top_edge, out.caption, out.clock);
  const double bottom_height = bottom.height();
  bottom.left = needs.ruler * out.scale + ruler_label;
  const double bottom_x = left_edge(bottom);
  bottom.place(bottom_x, out.view.y - 0.5 * f, out.ruler, out.key);
  if (bar.across > 0) out.bar = upright_bar(out.view, f);
  if (bar.up > 0) {
    const double width = std::min(room_x - 2 * (needs.bar_labels + 1.3) * f, 36 * f);
    out.bar = {(needs.width - width) / 2, out.view.y - bottom_height - 3 * f, width, 0.9 * f};
  }
  return out;
}

Layout lay_out_above(const Needs& needs, double floor) {
  const Layout beside = lay_out(needs, floor, true), below = lay_out(needs, floor, false);
  return below.scale > beside.scale ? below : beside;
}

constexpr double least_share = 0.55;  // that curves must leave of the tank's size

}  // namespace

Layout lay_out(const Needs& needs) {
  const double f = font_height(needs), strip = curve_strip(needs, f), pad = layout_pad * f;
  Layout alone = lay_out_above(needs, 0);
  if (strip == 0) return alone;
  Layout out = lay_out_above(needs, strip);
  if (out.scale < least_share * alone.scale) return alone;
  out.curves = lay_out_curves(needs.curves, {pad, 0, needs.width - 2 * pad, strip}, f);
  return out;
}

}  // namespace seiche::render
