#include "apps/run/run_info.hpp"

#include "apps/scene/scene_text.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps {

const char* version() { return SEICHE_VERSION; }

RunInfo run_info(const Scene& scene) {
  const Parameters& p = scene.parameters;
  RunInfo info;
  info.name = scene.name;
  info.version = version();
  info.scene_hash = scene_hash(scene);
  info.parameters = scene_text(scene);
  info.kernel = p.method.kernel;
  info.preset = name(p.preset);
  info.dimension = p.dimension();
  info.tank = tank_surface(p);
  info.closed = p.tank.closed;
  info.depth = p.fluid.depth;
  info.density = p.fluid.density;
  info.gravity = p.gravity.size();
  info.pull = greatest_pull(p);
  info.spacing = p.particles.spacing;
  info.excursion = motion_extent(p);
  info.frame_interval = 1 / scene.output.frame_rate;
  info.end = p.time.end;
  if (scene.samples()) info.sensors = sensor_columns(p);
  return info;
}

}  // namespace seiche::apps
