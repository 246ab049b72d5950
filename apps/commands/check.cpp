#include "apps/commands/check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "solver/make_simulation.hpp"

namespace seiche::apps {
namespace {

std::string motion_text(const Parameters::Motion& motion) {
  if (motion.type == MotionType::none) return "tank at rest";
  const std::string start = fmt::format("{} start", name(motion.start));
  if (motion.type == MotionType::harmonics)
    return fmt::format("moved by {} harmonics, {}", motion.harmonics.size(), start);
  if (motion.type == MotionType::file)
    return fmt::format("moved by {} samples of {}, {}", motion.series.time.size(), motion.file, start);
  return fmt::format("{} of {:g} {} at {:g} Hz, {}", motion.type_name(), motion.harmonic.amplitude,
                     row(motion.harmonic.of).rotation ? "degrees" : "m", motion.harmonic.frequency, start);
}

}  // namespace

std::string check_text(const Scene& scene) {
  const Parameters& p = scene.parameters;
  const auto [length, height, across] = tank_surface(p).size();
  const double l0 = p.particles.spacing, column = p.fluid.column > 0 ? p.fluid.column : length;
  const double layers = across > 0 ? std::round(across / l0) : 1;
  const double particles = std::round(column / l0) * std::round(p.fluid.depth / l0) * layers;
  const std::string width = across > 0 ? fmt::format(" x {:g}", across) : "";
  const std::string step = p.time.step > 0 ? fmt::format(" in steps of {:g} s", p.time.step) : "";
  return fmt::format(
      "{}: a good scene\n"
      "  tank    {:g} x {:g}{} m, {}, filled to {:g} m; {}\n"
      "  method  {} preset, kernel {}, spacing {:g} m: {:.0f} fluid particles\n"
      "  run     {:g} s{} at {:g} frames a second\n",
      scene.file, length, height, width, p.tank.closed ? "closed" : "open", p.fluid.depth, motion_text(p.motion),
      name(p.preset), p.method.kernel, l0, particles, p.time.end, step, scene.output.frame_rate);
}

}  // namespace seiche::apps
