#pragma once
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"

namespace seiche::solver {

/// Kinetic and potential energy of the liquid, as `Budget` has them.
template <int D>
class EnergySensor : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    if (!p.sensors.energy) return {};
    const char* unit = D == 3 ? "J" : "J/m";
    const double scale = Scales(p).energy;
    return {{"kinetic_energy", unit, "kinetic energy", ColumnKind::energy, Rest::zero, scale},
            {"potential_energy", unit, "potential energy", ColumnKind::energy, Rest::zero, scale}};
  }

  explicit EnergySensor(const SensorSite<D>&) {}

  void read(const Instant<D>& now, Scalars& values) override {
    values.insert(values.end(), {now.budget.kinetic, now.budget.potential});
  }
};

}  // namespace seiche::solver
