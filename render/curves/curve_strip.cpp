#include "render/curves/curve_strip.hpp"

#include <algorithm>

#include "render/curves/curve_key.hpp"
#include "render/curves/curve_panel.hpp"
#include "render/picture/axis.hpp"
#include "render/picture/curve_layout.hpp"
#include "render/picture/overlay.hpp"

namespace seiche::render {
namespace {

// Of the widest label on an axis that is cut into whatever number of parts, in font heights.
double labels_room(Range range) {
  double width = 0;
  for (int most = fewest_ticks; most <= most_ticks; ++most) width = std::max(width, label_width(axis_of(range, most)));
  return curve_font * width;
}

}  // namespace

CurveStrip::CurveStrip(const std::vector<SensorCurve>& curves) : curves_(curves) {}
CurveStrip::~CurveStrip() = default;

void CurveStrip::reserve(Needs& needs) const {
  for (const SensorCurve& curve : curves_) {
    CurveNeeds room;
    room.title = curve_font * title_width(curve);
    room.key = curve_font * key_width(curve);
    room.last_label = labels_room({0, curve.end});
    // The name of the times stands in the corner between both axes' labels.
    const double corner = curve_font * (text_width(CurvePanel::time_title) + name_gap) + room.last_label / 2;
    room.labels = std::max({labels_room(axis_range(curve)), labels_room(widest_range(curve)), corner});
    needs.curves.push_back(room);
  }
}

void CurveStrip::place(vtkRenderer* renderer, const Layout& layout, const Palette& colours) {
  for (std::size_t i = 0; i < layout.curves.size(); ++i)
    panels_.push_back(std::make_unique<CurvePanel>(renderer, layout.curves[i], layout.font, curves_[i], colours));
}

void CurveStrip::show(double time) {
  for (const auto& panel : panels_) panel->show(time);
}

}  // namespace seiche::render
