#include "solver/sensors/sensors.hpp"

#include <utility>

#include "solver/sensors/sensor_kinds.hpp"

namespace seiche::solver {

template <int D>
Sensors<D>::Sensors(const SensorSite<D>& site, double interval)
    : p_(site.p),
      interval_(interval),
      motion_(site.p.motion),
      cells_(site.tank.bounds(), site.p.particles.spacing),
      surface_(site.tank, site.p.gravity, site.p.particles.spacing, site.start),
      still_height_(mean_height(site.start, site.p.gravity)) {
  for (const SensorKind<D>& kind : sensor_kinds<D>())
    if (!kind.columns(p_).empty()) sensors_.push_back(kind.make(site));
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
  const Budget<D> all = budget(s, p_, still_height_, motion_.state(s.time));
  for (const auto& sensor : sensors_) sensor->read({s, cells_, surface_, all}, values);
}

template class Sensors<2>;
template class Sensors<3>;

}  // namespace seiche::solver
