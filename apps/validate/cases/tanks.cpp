#include <utility>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/cases/resting_tank.hpp"

// Tanks that aren't boxes, and boxes with baffles: at rest, and pushed once so that their liquid swings by itself.
// References are finite elements of the program's own, tested against others (scenes/tanks), and closed forms.
namespace seiche::apps::validate {
namespace {

/// One in 3-D: all are asked for the same, in shorter runs.
Asked in_3d(std::string title, std::string scene, std::optional<double> period) {
  return {.title = std::move(title),
          .scene = std::move(scene),
          .settings = {},
          .error = 0.2,
          .speed = 30,
          .rms_speed = 3,
          .period = period,
          .still_end = 3,
          .swing_end = 6};
}

}  // namespace

Findings tanks(Bench& bench) {
  return rest_and_swing(
      bench,
      {
          {.title = "circle, quarter full",
           .scene = "tanks/circle",
           .settings = {"fluid.fill_height=0.25", "particles.spacing=0.00625"},
           .error = 0.15,
           .speed = 12,
           .level = 0.1,
           .period = 0.3},
          {.title = "circle, half full",
           .scene = "tanks/circle",
           .settings = {},
           .error = 0.15,
           .speed = 12,
           .level = 0.1,
           .period = 0.3,
           .in_quick = true},
          {.title = "circle, three quarters full",
           .scene = "tanks/circle",
           .settings = {"fluid.fill_height=0.75", "particles.spacing=0.01875"},
           .error = 0.15,
           .speed = 18,
           .level = 0.1,
           .period = 0.8},
          {.title = "chamfer",
           .scene = "tanks/chamfer",
           .settings = {},
           .error = 0.15,
           .speed = 12,
           .level = 0.1,
           .period = 0.3},
          {.title = "hexagon",
           .scene = "tanks/hexagon",
           .settings = {},
           .error = 0.15,
           .speed = 12,
           .level = 0.1,
           .period = 0.3},
          {.title = "box turned by 20 degrees",
           .scene = "tanks/turned",
           .settings = {},
           .error = 0.15,
           .speed = 18,
           .level = 0.1},
          {.title = "box turned by 45 degrees",
           .scene = "tanks/turned",
           .settings = {"tank.points=[[0, 0], [0.353553, 0.353553], [0.141421, 0.565685], [-0.212132, 0.212132]]"},
           .error = 0.15,
           .speed = 18,
           .level = 0.1},
          {.title = "membrane, 38 m, by Froude's law",
           .scene = "membrane",
           .settings = {"motion.type=none", "particles.spacing=0.945", "output.probe_rate=100"},
           .error = 0.15,
           .speed = 12,
           .level = 0.1,
           .scale = 38 / 0.5},
          {.title = "baffle",
           .scene = "tanks/baffle",
           .settings = {},
           .error = 0.1,
           .speed = 12,
           .level = 0.1,
           .period = 1.5},
          {.title = "plate",
           .scene = "tanks/plate",
           .settings = {},
           .error = 0.1,
           .speed = 25,
           .level = 0.1,
           .period = 2,
           .in_quick = true},
          {.title = "divider between two levels",
           .scene = "tanks/divider",
           .settings = {},
           .error = 0.1,
           .speed = 15,
           .level = 0.1},
      },
      "Free sloshing, 20 particles deep");
}

Findings tanks_3d(Bench& bench) {
  return rest_and_swing(
      bench,
      {in_3d("sphere, half full", "tanks/sphere", 0.5), in_3d("upright cylinder", "tanks/upright", 0.5),
       in_3d("upright cylinder from STL", "tanks/upright-mesh", {}),
       in_3d("membrane with a length", "tanks/membrane-3d", {}), in_3d("lying cylinder, along it", "tanks/lying", 0.5),
       in_3d("square box", "tanks/square", 0.5)},
      "Free sloshing in 3-D, 12 particles deep");
}

}  // namespace seiche::apps::validate
