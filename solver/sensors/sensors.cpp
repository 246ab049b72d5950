#include "solver/sensors/sensors.hpp"

#include <utility>

namespace seiche::solver {
namespace {

/// Above still level [m], to 1e-9 l0: what round-off leaves of a lattice at rest is 0.
double elevation(double level, double depth, double l0) {
  const double grain = 1e-9 * l0;
  return std::round((level - depth) / grain) * grain + 0.0;  // + 0.0: never -0
}

}  // namespace

template <int D>
Sensors<D>::Sensors(const Parameters& p, double interval, const State<D>& s)
    : p_(p), interval_(interval), motion_(p.motion), cells_(p), surface_(p), walls_(p, s) {
  const Parameters::Sensors all = sensors_of(p);
  for (const auto& sensor : all.pressure) pressures_.emplace_back(sensor, p);
  const double l0 = p.particles.spacing;
  for (const auto& gauge : all.gauge)
    gauges_.emplace_back(gauge.x / l0, gauge.z / l0, surface_.count(0), surface_.count(1));
}

// 1e-12: sums of steps that should end at a sample miss it by their rounding.
template <int D>
bool Sensors<D>::is_due(double time, const SensorMemory& memory) const {
  return interval_ > 0 && static_cast<double>(memory.next) * interval_ <= time * (1 + 1e-12);
}

template <int D>
void Sensors<D>::before_step(const State<D>& s, double end, SensorMemory& memory) {
  if (!is_due(end, memory) || memory.last_time == s.time) return;
  evaluate(s, memory.last);
  memory.last_time = s.time;
}

template <int D>
void Sensors<D>::read(const State<D>& s, SensorMemory& memory) {
  if (!is_due(s.time, memory)) return;
  auto& [readings, last, last_time, next] = memory;
  evaluate(s, now_);
  for (; is_due(s.time, memory); ++next) {
    const double t = static_cast<double>(next) * interval_;
    readings.time.push_back(t);
    const double share = s.time > last_time && !last.empty() ? (t - last_time) / (s.time - last_time) : 1;
    for (std::size_t k = 0; k < now_.size(); ++k)
      readings.values.push_back(share == 1 ? now_[k] : last[k] + share * (now_[k] - last[k]));
    motion_.append(t, readings.values);
  }
  std::swap(last, now_);
  last_time = s.time;
}

template <int D>
void Sensors<D>::evaluate(const State<D>& s, Scalars& values) {
  values.clear();
  cells_.sort(s);
  surface_.find(s, cells_);
  for (const auto& sensor : pressures_) values.push_back(sensor.read(s, cells_));
  for (const auto& gauge : gauges_)
    values.push_back(elevation(gauge.level(surface_), p_.fluid.depth, p_.particles.spacing));
  const auto add = [&](const Vec<D>& v) { values.insert(values.end(), v.begin(), v.end()); };
  if (p_.sensors.force) {
    const Load<D> load = walls_.read(s, cells_);
    add(load.force);
    values.push_back(load.moment);
  }
  if (!p_.sensors.energy && !p_.sensors.volume) return;
  const Budget<D> all = budget(s, p_, motion_.pose(s.time));
  if (p_.sensors.energy) values.insert(values.end(), {all.kinetic, all.potential});
  if (p_.sensors.volume) {
    values.push_back(surface_.volume());
    add(all.centre);
  }
}

template class Sensors<2>;
template class Sensors<3>;

}  // namespace seiche::solver
