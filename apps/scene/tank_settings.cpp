#include "apps/scene/tank_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "apps/scene/files/points_file.hpp"
#include "apps/scene/stl/stl_file.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps {
namespace {

constexpr std::array level_keys{"depth", "fill", "fill_height", "volume"};

bool is_level(const Setting& setting) {
  return setting.option->section == "fluid" &&
         std::find(level_keys.begin(), level_keys.end(), setting.option->key) != level_keys.end();
}

bool is_given(const Setting& setting) {
  Scene scene;
  if (assign(*setting.option, scene, setting.value)) return true;  // a wrong value was meant
  const Value value = value_of(*setting.option, scene);
  const double* number = std::get_if<double>(&value);
  return number && *number > 0;
}

void read_points(Scene& scene, const std::string& file) {
  Parameters::Tank& tank = scene.parameters.tank;
  if (!tank.points.empty())
    throw BadParameters("tank.points and tank.file both tell the tank's points; leave one of them");
  tank.points = read_points_file(file, tank.shape);
  scene.given.file.clear();
}

void read_mesh(Scene& scene, const std::string& file) {
  if (!scene.given.unit)
    throw BadParameters(fmt::format(
        "tank.unit is missing: an STL file doesn't tell what its numbers are in; give unit = \"m\", \"cm\", "
        "\"mm\", \"in\" or \"ft\" with tank.file = \"{}\"",
        scene.given.file));
  scene.parameters.tank.mesh = read_stl_file(file, *scene.given.unit).mesh;
}

void read_file(Scene& scene, const std::filesystem::path& folder) {
  const TankShape shape = scene.parameters.tank.shape;
  const std::string file = (folder / scene.given.file).string();
  if (scene.given.unit && shape != TankShape::mesh)
    throw BadParameters(fmt::format("tank.unit means nothing to a tank.shape = \"{}\"; leave it out", name(shape)));
  if (scene.given.file.empty()) return;
  if (shape == TankShape::mesh) return read_mesh(scene, file);
  if (shape == TankShape::prism || shape == TankShape::revolve) return read_points(scene, file);
  throw BadParameters(fmt::format("tank.file means nothing to a tank.shape = \"{}\"; leave it out", name(shape)));
}

/// Each seed gets its depth, and the liquid the greatest of them.
void settle_seeds(Parameters& p) {
  for (auto& seed : p.fluid.seeds) {
    if (seed.depth == 0) seed.depth = p.fluid.depth;
    if (seed.depth == 0)
      throw BadParameters(fmt::format(
          "[[fluid.seed]] at x = {:.6g} m, y = {:.6g} m doesn't tell its depth, nor does [fluid]; give depth", seed.x,
          seed.y));
  }
  p.fluid.depth = std::ranges::max(p.fluid.seeds, {}, &Parameters::Fluid::Seed::depth).depth;
}

}  // namespace

void put_shape(const std::vector<Setting>& settings, Scene& scene) {
  const Option* shape = find_option("tank", "shape");
  for (const Setting& setting : settings)
    if (setting.option == shape) assign(*shape, scene, setting.value);
  scene.parameters.tank = initial_tank(scene.parameters.tank.shape);
}

void put_one_level(const std::vector<Setting>& settings, Scene& scene, std::vector<Complaint>& complaints) {
  std::vector<const Setting*> given;
  for (const Setting& setting : settings) {
    if (!is_level(setting) || !is_given(setting)) continue;
    // One that was said before, or in the file where this is on the command line, gives way.
    std::erase_if(given, [&](const Setting* other) {
      return other->option == setting.option || (setting.position == Position{} && other->position < setting.position);
    });
    given.push_back(&setting);
  }
  if (given.size() > 1) {
    complaints.push_back({fmt::format("{}: {} and {} both tell how full the tank is; leave one of them",
                                      given[1]->origin, title(*given[0]->option), title(*given[1]->option)),
                          given[1]->position});
    return;
  }
  if (given.empty() && scene.parameters.tank.shape == TankShape::box) return;
  scene.parameters.fluid.depth = 0;
  if (given.empty()) return;
  scene.given.fill = scene.given.fill_height = scene.given.volume = 0;
  assign(*given[0]->option, scene, given[0]->value);
}

void settle_tank(Scene& scene, const std::filesystem::path& folder) {
  Parameters& p = scene.parameters;
  auto& given = scene.given;
  read_file(scene, folder);
  const bool seeded = !p.fluid.seeds.empty();
  if (seeded && given.fill + given.volume > 0)
    throw BadParameters(fmt::format(
        "fluid.{} tells how full all of the tank is; give each [[fluid.seed]] its depth, or [fluid] a depth "
        "or a fill_height",
        given.fill > 0 ? "fill" : "volume"));
  if (!seeded && p.fluid.depth + given.fill + given.fill_height + given.volume == 0)
    throw BadParameters("[fluid] doesn't tell how full the tank is; give depth, fill, fill_height or volume");
  check_tank(p);
  if (given.fill > 0) p.fluid.depth = depth_holding(p, given.fill * tank_measures(p).volume);
  if (given.fill_height > 0) p.fluid.depth = given.fill_height * tank_measures(p).height;
  if (given.volume > tank_measures(p).volume)
    throw BadParameters(fmt::format("fluid.volume = {:.6g} {} is more than the tank's {:.6g}", given.volume,
                                    p.dimension() == 3 ? "m^3" : "m^2", tank_measures(p).volume));
  if (given.volume > 0) p.fluid.depth = depth_holding(p, given.volume);
  given.fill = given.fill_height = given.volume = 0;
  if (seeded) settle_seeds(p);
}

}  // namespace seiche::apps
