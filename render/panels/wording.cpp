#include "render/panels/wording.hpp"

#include <algorithm>

#include "render/panels/deviation.hpp"
#include "render/panels/panel.hpp"
#include "render/picture/overlay.hpp"

namespace seiche::render {
namespace {

// Of "amplitude 20 mm" all from the number on, or else the last word.
std::string value_in(const std::string& part) {
  std::size_t word = 0;
  while (part.find(' ', word) != std::string::npos &&
         std::string("+-.0123456789").find(part[word]) == std::string::npos)
    word = part.find(' ', word) + 1;
  return part.substr(word);
}

double note_width(const SensorCurve* curve, Wording wording) {
  constexpr double wide = 0.0888;
  if (!curve) return 0;
  return text_width(deviation_text(wide, curve->column, wording.brief_notes ? "" : curve->references.front().label));
}

// A run that fails says so; how far it was off before is no matter.
std::vector<PanelNeeds> needs_of(const std::vector<Variant>& variants, const SensorCurve* curve, Wording wording) {
  std::vector<PanelNeeds> needs;
  for (const Variant& variant : variants)
    needs.push_back({Panel::label_width(wording.brief_labels ? brief(variant.label) : variant.label),
                     variant.failed ? 0 : note_width(curve, wording)});
  return needs;
}

// Labels that find room count before notes that do.
std::pair<std::size_t, std::size_t> found_room(const GridLayout& layout, const std::vector<PanelNeeds>& needs) {
  std::size_t labels = 0, notes = 0;
  for (std::size_t i = 0; i < needs.size(); ++i) {
    labels += needs[i].label * layout.around.font <= layout.panels[i].view.width;
    notes += needs[i].note == 0 || layout.panels[i].note.width > 0;
  }
  return {labels, notes};
}

}  // namespace

std::string brief(const std::string& label) {
  std::string values;
  for (std::size_t start = 0; start <= label.size();) {
    const std::size_t comma = std::min(label.find(", ", start), label.size());
    values += (values.empty() ? "" : ", ") + value_in(label.substr(start, comma - start));
    start = comma + 2;
  }
  return values;
}

const SensorCurve* measured(const std::vector<SensorCurve>& curves) {
  const auto found =
      std::find_if(curves.begin(), curves.end(), [](const auto& curve) { return !curve.references.empty(); });
  return found == curves.end() ? nullptr : &*found;
}

std::string note_of(const SensorCurve* curve, std::size_t variant, double time, Wording wording) {
  if (!curve) return "";
  const Reference& reference = curve->references.front();
  return deviation_text(deviation(curve->traces[variant].series, reference.series, time), curve->column,
                        wording.brief_notes ? "" : reference.label);
}

std::pair<GridLayout, Wording> worded_layout(const Needs& picture, const std::vector<Variant>& variants,
                                             const SensorCurve* curve) {
  std::pair<GridLayout, Wording> best;
  std::pair<std::size_t, std::size_t> most;
  for (const Wording wording : {Wording{false, false}, Wording{false, true}, Wording{true, true}}) {
    const auto panels = needs_of(variants, curve, wording);
    GridLayout layout = lay_out_grid(picture, panels);
    const auto found = found_room(layout, panels);
    if (!best.first.panels.empty() && found <= most) continue;
    most = found;
    best = {std::move(layout), wording};
  }
  return best;
}

}  // namespace seiche::render
