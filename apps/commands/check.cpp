#include "apps/commands/check.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <vector>

#include "solver/make_simulation.hpp"
#include "solver/motion/motion_axes.hpp"
#include "solver/motion/record.hpp"
#include "solver/motion/warnings.hpp"

namespace seiche::apps {
namespace {

std::string motion_text(const Parameters& p) {
  const Parameters::Motion& motion = p.motion;
  if (motion.type == MotionType::none) return "tank at rest";
  const double greatest = greatest_acceleration(p).value;
  const std::string end = fmt::format("{} start, at most {:.3g} m/s^2 ({:.3g} g)", name(motion.start), greatest,
                                      greatest / solver::standard_gravity);
  if (motion.type == MotionType::harmonics)
    return fmt::format("moved by {} harmonics, {}", motion.harmonics.size(), end);
  if (motion.type == MotionType::file)
    return fmt::format("moved by {} samples of {}, {}", motion.series.time.size(), motion.file, end);
  return fmt::format("{} of {:g} {} at {:g} Hz, {}", motion.type_name(), motion.harmonic.amplitude,
                     row(motion.harmonic.of).rotation ? "degrees" : "m", motion.harmonic.frequency, end);
}

/// As in "surge +x, heave +y, roll about +z, by motion.axes = \"tank\"": of a 2-D run those that keep its plane.
std::string axes_text(const Parameters& p) {
  const Parameters::Motion& motion = p.motion;
  if (motion.type == MotionType::none) return {};
  std::string along, about;
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (p.dimension() == 2 && !in_plane(row, motion)) continue;
    const auto [axis, sign] = axis_of(row, motion);
    std::string& text = row.rotation ? about : along;
    text += fmt::format("{}{} {}{}{}", text.empty() ? "" : ", ", row.name, row.rotation ? "about " : "",
                        sign > 0 ? '+' : '-', "xyz"[axis]);
  }
  return fmt::format("{}, {}, by motion.axes = \"{}\"", along, about, name(motion.axes));
}

const char* origin_of(const Parameters::Tank& tank) {
  switch (tank.shape) {
    case TankShape::box:
      return "its lowest corner";
    case TankShape::prism:
      return "that of its points";
    case TankShape::membrane:
      return "the middle of its floor";
    case TankShape::mesh:
      return "that of its file";
    case TankShape::cylinder:
    case TankShape::sphere:
    case TankShape::revolve:
      break;
  }
  return "the lowest point of its axis or middle plane";
}

/// As in "first natural periods: 1.04, 0.62 s", in 3-D "1.04 s (across), 0.62 s (1 half wave along z)".
std::string periods_text(const Parameters& p) {
  const bool body = p.dimension() == 3;
  std::string text;
  for (const NaturalMode& mode : natural_modes(p, 3)) {
    text += fmt::format("{}{:.4g}", text.empty() ? "first natural periods: " : ", ", mode.period);
    if (body) text += fmt::format(" s ({})", mode.wave);
  }
  return text.empty() || body ? text : text + " s";
}

/// As in "2 baffles without thickness, 1 ring 0.01 m thick".
std::string baffles_text(const Parameters::Tank& tank) {
  std::map<std::pair<std::string, double>, int> counts;
  for (const auto& baffle : tank.baffles) ++counts[{"baffle", baffle.thickness}];
  for (const auto& ring : tank.rings) ++counts[{"ring", ring.thickness}];
  std::string text;
  for (const auto& [kind, count] : counts) {
    const auto& [what, thickness] = kind;
    text += fmt::format("{}{} {}{} {}", text.empty() ? "" : ", ", count, what, count > 1 ? "s" : "",
                        thickness > 0 ? fmt::format("{:g} m thick", thickness) : "without thickness");
  }
  return text;
}

/// To a nanometre, so that what is nearly 0 reads as 0.
double rounded(double length) { return std::round(length * 1e9) / 1e9 + 0.0; }

/// As in "to y = 0.1 m, 0.1 m deep", of chambers with levels of their own each after the other.
std::string levels_text(const Parameters& p, double bottom) {
  std::vector<double> depths;
  for (const auto& seed : p.fluid.seeds) depths.push_back(seed.depth);
  if (depths.empty()) depths.push_back(p.fluid.depth);
  std::string text;
  for (const double depth : depths) {
    if (!text.empty()) text += "; ";
    if (p.gravity.is_upright()) text += fmt::format("to y = {:.6g} m, ", bottom + depth);
    text += fmt::format("{:.5g} m deep", depth);
  }
  return p.gravity.is_upright() ? text : text + ", its surface square to gravity";
}

/// A line of what is told, none where there is nothing.
std::string line(const char* what, const std::string& told) {
  return told.empty() ? "" : fmt::format("  {:<8}{}\n", what, told);
}

std::string warnings_text(const Parameters& p) {
  std::string text;
  for (const std::string& warning : warnings(p)) text += line("warning", warning);
  return text;
}

}  // namespace

std::string check_text(const Scene& scene) {
  const Parameters& p = scene.parameters;
  const SurfaceMesh wall = tank_surface(p);
  const auto low = wall.low(), high = wall.high();
  const bool body = p.dimension() == 3;
  const TankMeasures measures = tank_measures(p);
  const double l0 = p.particles.spacing;
  const double liquid = p.fluid.column > 0 ? measures.liquid * p.fluid.column / wall.size()[0] : measures.liquid;
  std::string ends;
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(p.dimension()); ++axis)
    ends += fmt::format("{}{} from {:.6g} to {:.6g}", axis > 0 ? ", " : "", "xyz"[axis], rounded(low[axis]),
                        rounded(high[axis]));
  const std::string section = p.tank.section ? fmt::format(", in the plane {}", text_of(*p.tank.section)) : "";
  const std::string step = p.time.step > 0 ? fmt::format(" in steps of {:g} s", p.time.step) : "";
  return fmt::format(
      "{}: a good scene\n"
      "  tank    {}{}, {}: {} m; {:.5g} {}, wall {:.5g} {}; origin: {}\n"
      "{}{}"
      "  liquid  {}: {:.5g} {}, {:.3g} % of the tank\n"
      "{}"
      "  motion  {}\n"
      "{}"
      "  method  {} preset, kernel {}, spacing {:g} m: some {:.0f} fluid particles\n"
      "  run     {:g} s{} at {:g} frames a second\n"
      "{}",
      scene.file, name(p.tank.shape), section, p.tank.closed ? "closed" : "open", ends, measures.volume,
      body ? "m^3" : "m^2", measures.area, body ? "m^2" : "m", origin_of(p.tank), line("mended", mended_of(p)),
      line("baffles", baffles_text(p.tank)), levels_text(p, low[1]), liquid, body ? "m^3" : "m^2",
      100 * liquid / measures.volume, line("waves", periods_text(p)), motion_text(p), line("axes", axes_text(p)),
      name(p.preset), p.method.kernel, l0, liquid / std::pow(l0, p.dimension()), p.time.end, step,
      scene.output.frame_rate, warnings_text(p));
}

}  // namespace seiche::apps
