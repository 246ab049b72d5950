#include <utility>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/cases/resting_tank.hpp"

// Tanks that aren't boxes, and boxes with baffles: at rest, and pushed once so that their liquid swings by itself.
// References are finite elements of the program's own, tested against others (scenes/tanks), and closed forms.
namespace seiche::apps::validate {
namespace {

/// One in 2-D.
Asked in_2d(std::string title, std::string scene, double error, double speed, std::optional<double> period,
            std::vector<std::string> settings = {}) {
  return {.title = std::move(title),
          .scene = std::move(scene),
          .settings = std::move(settings),
          .error = error,
          .speed = speed,
          .level = 0.1,
          .period = period};
}

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
  Asked membrane = in_2d("membrane, 38 m, by Froude's law", "membrane", 0.15, 12, {},
                         {"motion.type=none", "particles.spacing=0.945", "output.probe_rate=100"});
  membrane.scale = 38 / 0.5;
  Asked circle = in_2d("circle, half full", "tanks/circle", 0.15, 12, 0.3);
  Asked plate = in_2d("plate", "tanks/plate", 0.1, 25, 2);
  circle.in_quick = plate.in_quick = true;
  return rest_and_swing(
      bench,
      {in_2d("circle, quarter full", "tanks/circle", 0.15, 12, 0.3,
             {"fluid.fill_height=0.25", "particles.spacing=0.00625"}),
       circle,
       in_2d("circle, three quarters full", "tanks/circle", 0.15, 18, 0.8,
             {"fluid.fill_height=0.75", "particles.spacing=0.01875"}),
       in_2d("chamfer", "tanks/chamfer", 0.15, 12, 0.3), in_2d("hexagon", "tanks/hexagon", 0.15, 12, 0.3),
       in_2d("box turned by 20 degrees", "tanks/turned", 0.15, 18, {}),
       in_2d("box turned by 45 degrees", "tanks/turned", 0.15, 18, {},
             {"tank.points=[[0, 0], [0.353553, 0.353553], [0.141421, 0.565685], [-0.212132, 0.212132]]"}),
       membrane, in_2d("baffle", "tanks/baffle", 0.1, 12, 1.5), plate,
       in_2d("divider between two levels", "tanks/divider", 0.1, 15, {})},
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
