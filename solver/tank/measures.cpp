#include "solver/tank/measures.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <vector>

#include "solver/errors.hpp"

namespace seiche::solver {
namespace {

using Tank = Parameters::Tank;
using enum TankShape;

/// A key of the tank, and what it is to each shape.
struct Measure {
  const char* key;
  bool (*given)(const Tank&);
  std::vector<TankShape> needed, optional;
};

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"length", [](const Tank& t) { return t.length > 0; }, {box, cylinder}, {membrane}},
      {"height", [](const Tank& t) { return t.height > 0; }, {box, membrane}, {}},
      {"width", [](const Tank& t) { return t.width > 0; }, {}, {box, prism}},
      {"breadth", [](const Tank& t) { return t.breadth > 0; }, {membrane}, {}},
      {"lower_chamfer",
       [](const Tank& t) {
         return t.lower_chamfer != std::array{0.0, 0.0};
       },
       {},
       {membrane}},
      {"upper_chamfer",
       [](const Tank& t) {
         return t.upper_chamfer != std::array{0.0, 0.0};
       },
       {},
       {membrane}},
      {"radius", [](const Tank& t) { return t.radius > 0; }, {cylinder, sphere}, {}},
      {"points", [](const Tank& t) { return !t.points.empty(); }, {prism, revolve}, {}},
      {"file", [](const Tank& t) { return !t.mesh.points.empty(); }, {mesh}, {}},
  };
  return all;
}

bool has(const std::vector<TankShape>& shapes, TankShape shape) {
  return std::find(shapes.begin(), shapes.end(), shape) != shapes.end();
}

/// Those that it needs or may have, as a scene calls them.
std::string keys_of(TankShape shape) {
  std::string keys;
  for (const Measure& measure : measures())
    if (has(measure.needed, shape) || has(measure.optional, shape))
      keys += fmt::format("{}tank.{}", keys.empty() ? "" : ", ", measure.key);
  return keys;
}

}  // namespace

Parameters::Tank initial_tank(TankShape shape) {
  Parameters::Tank tank;
  tank.shape = shape;
  if (shape != box) tank.length = tank.height = 0;
  return tank;
}

void check_measures(const Parameters::Tank& tank) {
  const auto shape = name(tank.shape);
  for (const Measure& measure : measures()) {
    const bool needed = has(measure.needed, tank.shape);
    if (needed && !measure.given(tank))
      throw BadParameters(
          fmt::format("tank.{} is missing: a tank.shape = \"{}\" has {}", measure.key, shape, keys_of(tank.shape)));
    if (!needed && !has(measure.optional, tank.shape) && measure.given(tank))
      throw BadParameters(fmt::format("tank.{} means nothing to a tank.shape = \"{}\", which has {}; leave it out",
                                      measure.key, shape, keys_of(tank.shape)));
  }
  if (!tank.closed && tank.shape != box)
    throw BadParameters(fmt::format("tank.closed = false needs a box: a tank.shape = \"{}\" has no rim", shape));
  if (tank.section && !tank.is_body())
    throw BadParameters(fmt::format("tank.section = \"{}\" cuts a tank that is 2-D already; leave it out, or give {}",
                                    text_of(*tank.section), tank.shape == membrane ? "tank.length" : "tank.width"));
}

}  // namespace seiche::solver
