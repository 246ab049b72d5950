#include "solver/modes/tank_modes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "solver/modes/cut_out.hpp"
#include "solver/tank/baffles/baffles_of.hpp"
#include "solver/tank/level_axes.hpp"

namespace seiche::solver::modes {
namespace {

/// The first of all that are added.
class First {
 public:
  explicit First(int count) : count_(static_cast<std::size_t>(count)) {}

  /// Returns whether any of them counts.
  bool add(const std::vector<Chamber>& chambers, const std::string& wave) {
    for (const Chamber& chamber : chambers)
      for (const Mode& mode : chamber.modes)
        all_.push_back({mode.frequency, wave, chamber.across.front(), chamber.across.back()});
    std::stable_sort(all_.begin(), all_.end(),
                     [](const TankMode& a, const TankMode& b) { return a.frequency < b.frequency; });
    all_.resize(std::min(all_.size(), count_));
    return std::any_of(all_.begin(), all_.end(), [&](const TankMode& mode) { return mode.wave == wave; });
  }

  const std::vector<TankMode>& all() const { return all_; }

 private:
  std::size_t count_;
  std::vector<TankMode> all_;
};

std::vector<TankMode> along(const Polygons& section, double length, char axis, double level, double gravity,
                            int count) {
  First first(count);
  first.add(section_modes(section, level, gravity, count), "across");
  for (int n = 1; n <= count; ++n) {
    const Across across{false, 0, n * std::numbers::pi / length};
    if (!first.add(section_modes(section, level, gravity, count, across),
                   fmt::format("{} half wave{} along {}", n, n > 1 ? "s" : "", axis)))
      break;
  }
  return first.all();
}

/// Whether the profile is a rectangle beside the axis: a cylinder with flat ends.
bool is_flat_ended(const Contour& half) {
  const Vec<2> size = half.bounds().size();
  return half.bounds().low[0] == 0 && half.area() > (1 - 1e-9) * size[0] * size[1];
}

}  // namespace

std::vector<TankMode> tank_modes(const MeshTank&, double, double, int) { return {}; }

Polygons polygons_of(const Contour& contour, double share) {
  Polygons polygons;
  for (const auto& corners : contour.polygons(share * contour.bounds().size().maxCoeff())) {
    auto& polygon = polygons.emplace_back();
    for (const auto& corner : corners) polygon.push_back(corner.position);
  }
  return polygons;
}

std::vector<TankMode> tank_modes(const Section& tank, double level, double gravity, int count) {
  First first(count);
  first.add(section_modes(polygons_of(tank.wall()), level, gravity, count), "across");
  return first.all();
}

std::vector<TankMode> tank_modes(const Extruded& tank, double level, double gravity, int count) {
  return along(polygons_of(tank.section().wall()), tank.z_high() - tank.z_low(), 'z', level, gravity, count);
}

std::vector<TankMode> tank_modes(const Revolved& tank, double level, double gravity, int count) {
  const double height = level - tank.origin()[1];
  if (tank.axis() != 1) {
    if (!is_flat_ended(tank.half())) return {};
    const Vec<2> size = tank.half().bounds().size();
    const Vec<2> low(0, tank.origin()[1] - size[0]), high(0, tank.origin()[1] + size[0]);
    const Contour circle({{{low, high, 1, 0}, {high, low, 1, 0}}});
    return along(polygons_of(circle), size[1], tank.axis() == 0 ? 'x' : 'z', level, gravity, count);
  }
  First first(count);
  const Polygons half = polygons_of(tank.half());
  for (int m = 0; m <= count + 1; ++m) {
    const std::string wave =
        m == 0 ? "the same all round" : fmt::format("{} wave{} round the axis", m, m > 1 ? "s" : "");
    if (!first.add(section_modes(half, height, gravity, count, {true, m, 0}), wave) && m > 0) break;
  }
  return first.all();
}

namespace {

/// The polygons on axes whose y is against gravity.
Polygons on_level_axes(Polygons polygons, const LevelAxes<2>& axes) {
  for (auto& polygon : polygons)
    for (Vec<2>& corner : polygon) corner = axes(corner);
  return polygons;
}

std::vector<TankMode> modes_of_section(const Parameters& p, int count) {
  const Section section = tank_section(p);
  const LevelAxes<2> axes(p.gravity);
  Polygons walls = polygons_of(section.wall());
  if (has_baffles(p.tank)) {
    const double l0 = p.particles.spacing;
    const Baffled tank(std::make_shared<Section>(section), baffle_lines(p, section.bounds()), l0, l0);
    walls = cut_out(walls, tank.solids(), tank.plates());
  }
  const double level = axes.bounds_of(section).low[1] + p.fluid.depth;
  First first(count);
  first.add(section_modes(on_level_axes(walls, axes), level, p.gravity.size(), count), "across");
  return first.all();
}

/// Of a tank that leans: those of an extruded one that leans across its length.
std::vector<TankMode> modes_of_leaning(const Body& body, const Parameters& p, int count) {
  const auto* tank = std::get_if<Extruded>(&body);
  if (!tank || p.gravity[2] != 0) return {};
  const LevelAxes<2> axes(p.gravity);
  return along(on_level_axes(polygons_of(tank->section().wall()), axes), tank->z_high() - tank->z_low(), 'z',
               axes.bounds_of(tank->section()).low[1] + p.fluid.depth, p.gravity.size(), count);
}

}  // namespace

std::vector<TankMode> tank_modes(const Parameters& p, int count) {
  if (p.dimension() == 2) return modes_of_section(p, count);
  if (has_baffles(p.tank)) return {};
  const Body body = tank_body(p);
  if (!p.gravity.is_upright()) return modes_of_leaning(body, p, count);
  return std::visit(
      [&](const auto& tank) { return tank_modes(tank, tank.bounds().low[1] + p.fluid.depth, p.gravity.size(), count); },
      body);
}

}  // namespace seiche::solver::modes
