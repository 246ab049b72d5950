#pragma once
#include <cmath>

#include "solver/sensors/scales.hpp"
#include "solver/sensors/sensor.hpp"
#include "solver/tank/pools.hpp"

namespace seiche::solver {

/// The centre of the liquid's still surface: the mean place of the cells just below it [m].
template <int D>
Vec<D> centre_of_surface(const Parameters& p, const Shape<D>& tank) {
  Vec<D> sum = Vec<D>::Zero();
  double shares = 0;
  const auto add = [&](const CellPart<D>& inside) {
    sum += inside.share * inside.centroid;
    shares += inside.share;
  };
  for (const Pool<D>& pool : levels_of(p, tank)) {
    const int top = pool.lattice.count[1] - 1;
    for (const auto& part : pool.parts)
      if (part.cell[1] == top) add(part.inside);
    if (p.fluid.seeds.empty())
      pool.lattice.each([&](const auto& cell) {
        if (cell[1] == top) add(pool.lattice.part_inside(tank, cell));
      });
  }
  return shares > 0 ? Vec<D>(sum / shares) : sum;
}

/// Angular momentum of the liquid about the vertical through the centre c of its still surface, of 3-D runs:
///   up . sum m (r - c) x u,   u relative to the tank [kg m^2/s],
/// positive from x towards -z, anticlockwise seen from above. A wave that goes to and fro has none, one that goes round
/// keeps its sign.
template <int D>
class SwirlSensor : public Sensor<D> {
 public:
  static std::vector<Column> columns(const Parameters& p) {
    if (D == 2 || !p.sensors.volume) return {};
    return {{"swirl", "kg m^2/s", "swirl", ColumnKind::swirl, Rest::zero, Scales(p).swirl}};
  }

  explicit SwirlSensor(const SensorSite<D>& site)
      : mass_(site.p.fluid.density * std::pow(site.p.particles.spacing, D)),
        up_(LevelAxes<3>(site.p.gravity).up()),
        centre_(centre_of_surface(site.p, site.tank)) {}

  void read(const Instant<D>& now, Scalars& values) override {
    if constexpr (D == 3) {
      Vec<3> sum = Vec<3>::Zero();
      for (std::size_t i = 0; i < now.s.size(); ++i)
        if (now.s.kind[i] == Kind::fluid) sum += (now.s.position[i] - centre_).cross(now.s.velocity[i]);
      values.push_back(mass_ * up_.dot(sum));
    }
  }

 private:
  double mass_;  ///< of a particle [kg]
  Vec<3> up_;
  Vec<D> centre_;
};

}  // namespace seiche::solver
