#include "apps/commands/kernels.hpp"

#include <fmt/format.h>

#include <array>

#include "apps/run/run_info.hpp"
#include "render/outputs.hpp"
#include "solver/operators/kernels.hpp"

namespace seiche::apps {
namespace {

constexpr std::array shown{0.1, 0.25, 0.5, 0.75, 0.9, 1.0};  // r/r_e

double at(const solver::Kernel& kernel, double r) {
  return std::visit([r](const auto& w) { return w(r); }, kernel);
}

}  // namespace

std::string kernels_text() {
  std::string result = "Kernels of Table 1 (Pan, Zhang, Lu 2008), with q = r/r_e; each is 0 beyond r_e.\n\n";
  for (const auto& kernel : solver::kernel_table(1.0)) {
    std::visit([&](const auto& w) { result += fmt::format("{}  w = {}\n     {}\n", w.name, w.formula, w.source); },
               kernel);
  }
  result += "\n  q ";
  for (const double q : shown) result += fmt::format("{:>9}", q);
  for (const auto& kernel : solver::kernel_table(1.0)) {
    result += fmt::format("\n{:<4}", solver::name(kernel));
    for (const double q : shown) result += fmt::format("{:9.4f}", at(kernel, q));
  }
  return result + "\n";
}

void draw_kernels(const std::filesystem::path& file) {
  constexpr int points = 400;
  constexpr double nearest = 0.25;  // KF1 grows without bound towards r = 0; from here on all five share one scale.
  std::vector<render::Curve> curves;
  for (const auto& kernel : solver::kernel_table(1.0)) {
    render::Curve curve{std::string(solver::name(kernel)), {}, {}};
    for (int i = 0; i <= points; ++i) {
      const double q = static_cast<double>(i) / points;
      if (curve.name == "KF1" && q < nearest) continue;
      curve.x.push_back(q);
      curve.y.push_back(at(kernel, q));
    }
    curves.push_back(std::move(curve));
  }
  const render::Image image =
      render::draw_curves(curves, "Kernel functions of Table 1", "r / r_e [-]", "w [-]", 1280, 720);
  render::write_png(file, image, {{"Software", fmt::format("seiche {}", version())}});
}

}  // namespace seiche::apps
