#include "render/picture/overlay.hpp"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cctype>
#include <cmath>
#include <numbers>
#include <sstream>

#include "render/picture/pixels.hpp"

namespace seiche::render {
namespace {

constexpr int dpi = 72;  // a font of size s is then s pixels high

}  // namespace

void set_font(vtkTextProperty* style) {
  style->SetFontFamily(VTK_FONT_FILE);
  style->SetFontFile(SEICHE_FONT);
}

struct Overlay::Shapes {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkUnsignedCharArray> colours;
  std::vector<vtkSmartPointer<vtkTextActor>> texts;
};

Overlay::Overlay(vtkRenderer* renderer, double opacity) : renderer_(renderer), shapes_(std::make_unique<Shapes>()) {
  shapes_->colours->SetNumberOfComponents(3);
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(shapes_->points);
  polygons->SetPolys(shapes_->cells);
  polygons->GetCellData()->SetScalars(shapes_->colours);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(polygons);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetOpacity(opacity);
  renderer_->AddActor2D(actor);
}

Overlay::~Overlay() = default;

void Overlay::polygon(const std::vector<Point>& corners, Rgb colour) {
  shapes_->cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const auto& [x, y] : corners)
    shapes_->cells->InsertCellPoint(shapes_->points->InsertNextPoint(sharpness * x, sharpness * y, 0));
  shapes_->colours->InsertNextTypedTuple(colour.data());
}

void Overlay::box(const Box& box, Rgb colour) {
  polygon({{box.x, box.y}, {box.right(), box.y}, {box.right(), box.top()}, {box.x, box.top()}}, colour);
}

void Overlay::ring(double x, double y, double inner, double outer, Rgb colour) {
  constexpr int parts = 48;
  const auto at = [&](double radius, int part) -> std::array<double, 2> {
    const double angle = 2 * std::numbers::pi * part / parts;
    return {x + radius * std::cos(angle), y + radius * std::sin(angle)};
  };
  for (int part = 0; part < parts; ++part)
    polygon({at(inner, part), at(outer, part), at(outer, part + 1), at(inner, part + 1)}, colour);
}

void Overlay::cross(double x, double y, double reach, double width, Rgb colour) {
  const double d = reach / std::numbers::sqrt2;
  line({{x - d, y - d}, {x + d, y + d}}, width, colour);
  line({{x - d, y + d}, {x + d, y - d}}, width, colour);
}

void Overlay::line(const Line& points, double width, Rgb colour) {
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto [ax, ay] = points[i - 1];
    const auto [bx, by] = points[i];
    const double length = std::hypot(bx - ax, by - ay);
    if (length == 0) continue;
    const double dx = (bx - ax) / length * width / 2, dy = (by - ay) / length * width / 2;
    // A piece reaches half a width into its neighbours, which fills the notch between them.
    const double before = i > 1 ? 1 : 0, after = i + 1 < points.size() ? 1 : 0;
    const Point a{ax - before * dx, ay - before * dy}, b{bx + after * dx, by + after * dy};
    polygon({{a[0] - dy, a[1] + dx}, {b[0] - dy, b[1] + dx}, {b[0] + dy, b[1] - dx}, {a[0] + dy, a[1] - dx}}, colour);
  }
}

void Overlay::clear() {
  for (const auto& text : shapes_->texts) renderer_->RemoveActor2D(text);
  shapes_->texts.clear();
  shapes_->points->Reset();
  shapes_->cells->Reset();
  shapes_->colours->Reset();
}

vtkTextActor* Overlay::text(const std::string& words, double x, double y, double font, Align align, Rgb colour) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(words.c_str());
  actor->SetTextScaleModeToNone();
  actor->SetPosition(std::round(sharpness * x), std::round(sharpness * y));
  vtkTextProperty* style = actor->GetTextProperty();
  set_font(style);
  style->SetFontSize(static_cast<int>(std::lround(sharpness * font)));
  style->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
  style->SetVerticalJustificationToCentered();
  if (align == Align::left) style->SetJustificationToLeft();
  if (align == Align::centre) style->SetJustificationToCentered();
  if (align == Align::right) style->SetJustificationToRight();
  renderer_->AddActor2D(actor);
  shapes_->texts.emplace_back(actor);
  return actor;
}

double text_width(const std::string& words) {
  constexpr int font = 100;
  vtkNew<vtkTextProperty> style;
  set_font(style);
  style->SetFontSize(font);
  int box[4] = {};
  if (!vtkTextRenderer::GetInstance()->GetBoundingBox(style, words, box, dpi)) return 0;
  return static_cast<double>(box[1] - box[0] + 1) / font;
}

std::vector<std::string> wrapped(const std::string& words, double room) {
  constexpr std::size_t longest_unit = 3;
  std::vector<std::string> parts;
  std::istringstream in(words);
  for (std::string word; in >> word;) {
    if (!parts.empty() && word.size() <= longest_unit && std::isdigit(static_cast<unsigned char>(parts.back().back())))
      parts.back() += " " + word;
    else
      parts.push_back(word);
  }
  std::vector<std::string> lines;
  for (const std::string& part : parts) {
    if (!lines.empty() && text_width(lines.back() + " " + part) <= room)
      lines.back() += " " + part;
    else
      lines.push_back(part);
  }
  return lines;
}

std::string shortened(std::string words, double room) {
  if (text_width(words) <= room) return words;
  // Between characters, which may be several bytes long.
  while (!words.empty() && text_width(words + "\u2026") > room) {
    while (!words.empty() && (words.back() & 0xc0) == 0x80) words.pop_back();
    if (!words.empty()) words.pop_back();
  }
  return words + "\u2026";
}

}  // namespace seiche::render
