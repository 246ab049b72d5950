#include <vtkAxis.h>
#include <vtkChartXY.h>
#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotPoints.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

#include "render/curves/chart_axis.hpp"
#include "render/gl/window.hpp"
#include "render/outputs.hpp"
#include "render/picture/overlay.hpp"
#include "render/picture/palette.hpp"
#include "render/picture/pixels.hpp"

namespace seiche::render {
namespace {

constexpr Rgb foreground{34, 34, 34};

void style_text(vtkTextProperty* text, double size) {
  set_font(text);
  text->SetFontSize(static_cast<int>(std::lround(size)));
  text->SetColor(0.13, 0.13, 0.13);
  text->BoldOff();
}

void style_axis(vtkAxis* axis, const Axis& plan, double font) {
  axis->SetTitle("");
  style_text(axis->GetLabelProperties(), 0.85 * font);
  axis->GetPen()->SetWidth(static_cast<float>(font / 14));
  axis->SetLabelOffset(static_cast<float>(0.55 * font));
  axis->SetTickLength(static_cast<float>(0.3 * font));
  axis->GetGridPen()->SetColor(228, 228, 228);
  axis->GetGridPen()->SetWidth(static_cast<float>(font / 20));
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const Tick& tick : plan.ticks) {
    positions->InsertNextValue(tick.position);
    labels->InsertNextValue(tick.label);
  }
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(plan.range.low, plan.range.high);
  axis->SetCustomTickPositions(positions, labels);
}

Rgb colour_of(const Curve& curve, std::size_t number) {
  return curve.mark == Mark::line ? line_colours[number % line_colours.size()] : Rgb{0, 0, 0};
}

void add_curve(vtkChartXY* chart, const Curve& curve, std::size_t number, Scales scales, double font) {
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("x");
  y->SetName(curve.name.c_str());
  for (std::size_t i = 0; i < std::min(curve.x.size(), curve.y.size()); ++i) {
    x->InsertNextValue(place_on(scales.x, curve.x[i]));
    y->InsertNextValue(place_on(scales.y, curve.y[i]));
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* line = chart->AddPlot(curve.mark == Mark::points ? vtkChart::POINTS : vtkChart::LINE);
  line->SetInputData(table, 0, 1);
  const Rgb colour = colour_of(curve, number);
  line->SetColor(colour[0], colour[1], colour[2], 255);
  line->SetWidth(static_cast<float>(font / 7));
  if (curve.mark == Mark::points) {
    vtkPlotPoints* points = vtkPlotPoints::SafeDownCast(line);
    points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
    points->SetMarkerSize(static_cast<float>(0.4 * font));
  }
  if (curve.mark == Mark::dashes) line->GetPen()->SetLineType(vtkPen::DASH_LINE);
}

// One row below the title, since a legend inside a chart covers what waves to and fro.
void add_legend(Overlay& overlay, const std::vector<Curve>& curves, double middle, double y, double font) {
  const double sample = 1.8 * font, gap = 0.5 * font, apart = 1.6 * font, thick = font / 7;
  double width = -apart;
  for (const Curve& curve : curves) width += sample + gap + text_width(curve.name) * font + apart;
  double x = middle - 0.5 * width;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Rgb colour = colour_of(curves[i], i);
    if (curves[i].mark == Mark::line) overlay.box({x, y - 0.5 * thick, sample, thick}, colour);
    if (curves[i].mark == Mark::dashes)
      for (int dash = 0; dash < 5; ++dash)
        overlay.box({x + 2 * dash * sample / 9, y - 0.5 * thick, sample / 9, thick}, colour);
    if (curves[i].mark == Mark::points) overlay.ring(x + 0.5 * sample, y, 0, 0.2 * font, colour);
    x += sample + gap;
    overlay.text(curves[i].name, x, y, font, Align::left, foreground);
    x += text_width(curves[i].name) * font + apart;
  }
}

}  // namespace

Image draw_curves(const std::vector<Curve>& curves, const std::string& title, const std::string& x_label,
                  const std::string& y_label, int width, int height, Scales scales) {
  const double font = std::max(9.0, std::min(width / 1280.0, height / 720.0) * 24);  // in pixels of the picture
  const double inner = sharpness * font;                                             // and of the window
  vtkNew<vtkChartXY> chart;
  for (std::size_t i = 0; i < curves.size(); ++i) add_curve(chart, curves[i], i, scales, inner);
  style_axis(chart->GetAxis(vtkAxis::BOTTOM), chart_axis(curves, &Curve::x, scales.x), inner);
  style_axis(chart->GetAxis(vtkAxis::LEFT), chart_axis(curves, &Curve::y, scales.y), inner);
  // Titles are laid over: the chart's own stand too close to the numbers.
  const Box room{2.8 * font, 2.8 * font, width - 4.6 * font, height - 7.4 * font};
  const auto pixels = [](double size) { return static_cast<float>(sharpness * size); };
  chart->SetAutoSize(false);
  chart->SetSize({pixels(room.x), pixels(room.y), pixels(room.width), pixels(room.height)});

  vtkNew<vtkContextScene> scene;
  scene->AddItem(chart);
  vtkNew<vtkContextActor> actor;
  actor->SetScene(scene);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  renderer->SetBackgroundAlpha(1);
  renderer->AddActor(actor);
  scene->SetRenderer(renderer);
  Overlay titles(renderer);
  titles.text(title, width / 2.0, height - 1.6 * font, 1.15 * font, Align::centre, foreground);
  add_legend(titles, curves, room.x + room.width / 2, height - 3.4 * font, font);
  titles.text(x_label, room.x + room.width / 2, 1.6 * font, font, Align::centre, foreground);
  titles.text(y_label, 1.6 * font, room.y + room.height / 2, font, Align::centre, foreground)
      ->GetTextProperty()
      ->SetOrientation(90);

  const auto window = make_window(sharpness * width, sharpness * height);
  window->AddRenderer(renderer);
  window->Render();
  return PixelReader().read(window);
}

}  // namespace seiche::render
