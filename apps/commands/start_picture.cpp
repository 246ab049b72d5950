#include "apps/commands/start_picture.hpp"

#include <fmt/format.h>

#include "apps/run/run_info.hpp"
#include "render/outputs.hpp"
#include "solver/make_simulation.hpp"
#include "solver/motion/motion_axes.hpp"

namespace seiche::apps {
namespace {

/// The pivot, where it is in the tank's bounds.
Double3 origin_of(const Parameters::Motion& m, const SurfaceMesh& tank) {
  const Double3 low = tank.low(), high = tank.high(), pivot{m.pivot_x, m.pivot_y, m.pivot_z};
  Double3 middle{};
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    middle[axis] = 0.5 * (low[axis] + high[axis]);
    inside = inside && pivot[axis] >= low[axis] && pivot[axis] <= high[axis];
  }
  return inside ? pivot : middle;
}

render::MotionMarks marks_of(const Parameters& p) {
  render::MotionMarks marks{origin_of(p.motion, tank_surface(p)), {}};
  for (const DegreeOfFreedomRow& row : degrees_of_freedom) {
    if (p.dimension() == 2 && !in_plane(row, p.motion)) continue;
    const auto [axis, sign] = axis_of(row, p.motion);
    Double3 direction{};
    direction[static_cast<std::size_t>(axis)] = sign;
    const std::string name =
        row.rotation ? std::string(row.name) : fmt::format("{} {}{}", row.name, sign > 0 ? "+" : "\u2212", "xyz"[axis]);
    marks.marks.push_back({name, row.rotation, direction});
  }
  return marks;
}

}  // namespace

void draw_start(const Scene& scene, const std::filesystem::path& file) {
  const FramePtr frame = make_simulation(scene.parameters, 0)->frame(0);
  render::Look look = scene.look;
  look.curves.emplace();
  const RunInfo run = run_info(scene);
  render::write_png(file, render::draw_frame(run, look, *frame, marks_of(scene.parameters)),
                    {{"Software", fmt::format("seiche {}", run.version)}, {"Scene", run.scene_hash}});
}

}  // namespace seiche::apps
