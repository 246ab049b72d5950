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
bool Sensors<D>::is_due(double time) const {
  return interval_ > 0 && next_ * interval_ <= time * (1 + 1e-12);
}

template <int D>
void Sensors<D>::before_step(const State<D>& s, double end) {
  if (!is_due(end) || last_time_ == s.time) return;
  evaluate(s, last_);
  last_time_ = s.time;
}

template <int D>
void Sensors<D>::read(const State<D>& s) {
  if (!is_due(s.time)) return;
  evaluate(s, now_);
  for (; is_due(s.time); ++next_) {
    const double t = next_ * interval_;
    readings_.time.push_back(t);
    const double share = s.time > last_time_ && !last_.empty() ? (t - last_time_) / (s.time - last_time_) : 1;
    for (std::size_t k = 0; k < now_.size(); ++k)
      readings_.values.push_back(share == 1 ? now_[k] : last_[k] + share * (now_[k] - last_[k]));
    motion_.append(t, readings_.values);
  }
  std::swap(last_, now_);
  last_time_ = s.time;
}

template <int D>
Readings Sensors<D>::take() {
  return std::exchange(readings_, {});
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
  const Budget<D> all = budget(s, p_);
  if (p_.sensors.energy) values.insert(values.end(), {all.kinetic, all.potential});
  if (p_.sensors.volume) {
    values.push_back(surface_.volume());
    add(all.centre);
  }
}

template class Sensors<2>;
template class Sensors<3>;

}  // namespace seiche::solver
