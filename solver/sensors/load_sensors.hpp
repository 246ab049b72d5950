#pragma once
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "solver/motion/motion.hpp"
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/sensors/sensor_list.hpp"
#include "solver/sensors/wall_load.hpp"

namespace seiche::solver {

/// Force and moment of the liquid: on all of the wall about the pivot, and what the scene's load sensors ask for,
///   M' = M + (pivot - about) x F,
/// F and M those of the sensor's part of the wall, both turned into the lab's axes where it says so.
template <int D>
class LoadSensors : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    std::vector<Column> all;
    if (!p.sensors.force && p.sensors.load.empty()) return all;
    const Scales scales(p);
    const auto force = [&](const std::string& name, const std::string& title, Rest rest) {
      all.push_back({name, D == 3 ? "N" : "N/m", title, ColumnKind::force, rest, scales.force});
    };
    const auto moment = [&](const std::string& name, const std::string& title) {
      all.push_back({name, D == 3 ? "N m" : "N m/m", title, ColumnKind::moment, Rest::first_value, scales.moment});
    };
    const std::vector<std::string> axes =
        D == 3 ? std::vector<std::string>{"x", "y", "z"} : std::vector<std::string>{"x", "y"};
    if (p.sensors.force) {
      for (const std::string& axis : axes)
        force("force_" + axis, "force " + axis, axis == "y" ? Rest::first_value : Rest::zero);
      moment("moment", "moment");
    }
    for (const auto& load : p.sensors.load) {
      const std::string words = ", " + in_words(load.name);
      for (const std::string& axis : axes)
        force(fmt::format("force_{}_{}", axis, load.name), fmt::format("force {}{}", axis, words), Rest::first_value);
      if (D == 2) moment("moment_" + load.name, "moment" + words);
      for (const std::string& axis : axes)
        if (D == 3) moment(fmt::format("moment_{}_{}", axis, load.name), fmt::format("moment {}{}", axis, words));
    }
    return all;
  }

  explicit LoadSensors(const SensorSite<D>& site)
      : motion_(site.p.motion),
        pivot_(site.p.motion.pivot_x, site.p.motion.pivot_y, site.p.motion.pivot_z),
        all_(site.p.sensors.force),
        sensors_(site.p.sensors.load),
        walls_(site.tank.surface(), pivot_.head<D>(), site.p.particles.spacing) {
    if (sensors_.empty()) return;
    const SurfaceMesh wall = site.tank.surface();
    for (const auto& load : sensors_) patches_.push_back(patch_of(load, wall));
  }

  /// The place of the sensor's patch in the wall; `whole` of all of it, `none` where there is no such patch.
  static constexpr int whole = -1, none = -2;
  static int patch_of(const Parameters::LoadSensor& load, const SurfaceMesh& wall) {
    if (load.on == "tank") return whole;
    for (std::size_t k = 0; k < wall.patches.size(); ++k)
      if (wall.patches[k].name == load.on) return static_cast<int>(k);
    return none;
  }

  void read(const Instant<D>& now, Scalars& values) override {
    const Load<D> total = walls_.read(now.s, now.cells);
    if (all_) {
      values.insert(values.end(), total.force.begin(), total.force.end());
      values.push_back(total.moment[2]);
    }
    if (sensors_.empty()) return;
    const Eigen::Quaterniond to_lab = motion_.state(now.s.time).orientation;
    for (std::size_t k = 0; k < sensors_.size(); ++k) {
      const Load<D> load = patches_[k] == whole ? total : walls_.on_patch(patches_[k]);
      Eigen::Vector3d force = Eigen::Vector3d::Zero();
      force.head<D>() = load.force;
      Eigen::Vector3d moment = load.moment + (pivot_ - Eigen::Vector3d(sensors_[k].about.data())).cross(force);
      if (sensors_[k].axes == LoadAxes::lab) force = to_lab * force, moment = to_lab * moment;
      values.insert(values.end(), force.begin(), force.begin() + D);
      values.insert(values.end(), moment.begin() + (D == 3 ? 0 : 2), moment.end());
    }
  }

 private:
  Motion motion_;
  Eigen::Vector3d pivot_;  ///< [m]
  bool all_;               ///< whether the total is asked for
  std::vector<Parameters::LoadSensor> sensors_;
  std::vector<int> patches_;  ///< of each
  WallLoad<D> walls_;
};

}  // namespace seiche::solver
