#include "render/panels/panel.hpp"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>

#include "render/curves/curve_key.hpp"
#include "render/picture/pixels.hpp"

namespace seiche::render {
namespace {

constexpr double veiled = 0.72;                           // of the picture's colours, what the veil hides
constexpr double message_pad = 0.4;                       // in font heights
constexpr double widest_message = 0.8;                    // of the panel
constexpr double sample_width = 1.4, after_sample = 0.4;  // of the curve before the label, in font heights

// The renderer draws in this box of the picture, and nowhere else.
void confine(vtkRenderer* renderer, const Box& box, const Look& look) {
  const double width = look.width, height = look.height;
  renderer->SetViewport(box.x / width, box.y / height, box.right() / width, box.top() / height);
}

double middle(const Box& box) { return box.y + box.height / 2; }

}  // namespace

Panel::Panel(vtkRenderWindow* window, vtkRenderer* words, const Variant& variant, std::size_t number, const Look& look,
             const View& view, const GridLayout& layout, const Palette& colours, double finest)
    : boxes_(layout.panels[number]), font_(layout.around.font), words_(words) {
  const Box& box = boxes_.view;
  for (vtkRenderer* renderer : {tank_.Get(), veil_.Get()}) {
    confine(renderer, box, look);
    window->AddRenderer(renderer);
  }
  set_background(tank_, look, colours.background);
  veil_->SetLayer(1);
  veil_->SetDraw(false);
  Layout inside = layout.around;
  inside.view = {0, 0, box.width, box.height};
  view.aim(tank_, inside, static_cast<int>(box.width), static_cast<int>(box.height));
  view_.emplace(tank_, variant.run, look, inside, colours, finest);
  place_label(variant, number, colours);
  place_message(variant, colours);
}

Panel::~Panel() = default;

double Panel::label_width(const std::string& label) { return sample_width + after_sample + text_width(label); }

void Panel::place_label(const Variant& variant, std::size_t number, const Palette& colours) {
  const Box& at = boxes_.label;
  const double y = middle(at), indent = (sample_width + after_sample) * font_;
  words_.line({{at.x, y}, {at.x + sample_width * font_, y}}, 1.6 * curve_width * font_, colours.runs[number]);
  const std::string label = shortened(variant.label, (at.width - indent) / font_ + 0.01);
  words_.text(label, at.x + indent, y, font_, Align::left, colours.foreground);
  if (boxes_.note.width > 0)
    note_ = words_.text("", boxes_.note.right(), middle(boxes_.note), font_, Align::right, colours.foreground);
}

// Lines at the top of the panel, above what liquid there is, on paper; parts that have no room are left out.
void Panel::place_message(const Variant& variant, const Palette& colours) {
  const Box& box = boxes_.view;
  Overlay(veil_, veiled).box({0, 0, box.width, box.height}, colours.background);
  const double line = 1.3 * font_, room = widest_message * box.width / font_ - 2 * message_pad;
  std::vector<std::string> lines;
  for (const std::string& part : variant.message) {
    const std::size_t before = lines.size();
    for (const std::string& words : wrapped(part, room)) lines.push_back(shortened(words, room));
    if (static_cast<double>(lines.size()) * line + 2 * message_pad * font_ > box.height) lines.resize(before);
  }
  if (lines.empty()) return;
  double widest = 0;
  for (const std::string& words : lines) widest = std::max(widest, text_width(words));
  const auto count = static_cast<double>(lines.size());
  const double width = (widest + 2 * message_pad) * font_, height = count * line + message_pad * font_;
  Overlay paper(veil_);
  const double top = box.height - std::min(message_pad * font_, box.height - height);
  paper.box({(box.width - width) / 2, top - height, width, height}, colours.background);
  double y = top - (height - (count - 1) * line) / 2;
  for (const std::string& words : lines) {
    paper.text(words, box.width / 2, y, font_, Align::centre, colours.foreground);
    y -= line;
  }
}

void Panel::show(const PanelFrame& frame, Range range, const std::string& note) {
  view_->show(*frame.frame, range);
  veil_->SetDraw(frame.ended);
  if (note_) note_->SetInput(note.c_str());
}

}  // namespace seiche::render
