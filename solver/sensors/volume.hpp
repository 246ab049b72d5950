#pragma once
#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"

namespace seiche::solver {

/// Space below the surface, a gap (NaN) where liquid at the roof has so much gas below it that it isn't the liquid's;
/// and the liquid's centre of mass in the tank's frame.
template <int D>
class VolumeSensor : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    if (!p.sensors.volume) return {};
    const Scales scales(p);
    std::vector<Column> all{
        {"volume", D == 3 ? "m^3" : "m^2", "volume", ColumnKind::volume, Rest::first_value, scales.volume}};
    for (const char* axis : {"x", "y", "z"})
      if (all.size() <= D)
        all.push_back({axis + std::string("_mass"), "m", axis + std::string(" mass"), ColumnKind::centre,
                       Rest::first_value, scales.length});
    return all;
  }

  explicit VolumeSensor(const SensorSite<D>&) {}

  void read(const Instant<D>& now, Scalars& values) override {
    values.push_back(now.surface.volume());
    values.insert(values.end(), now.budget.centre.begin(), now.budget.centre.end());
  }
};

}  // namespace seiche::solver
