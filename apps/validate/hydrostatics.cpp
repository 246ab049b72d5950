#include "apps/validate/hydrostatics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "apps/common/series.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {
namespace {

template <class Of>
std::vector<double> of_fluid(const Frame& frame, Of of) {
  std::vector<double> all;
  for (std::size_t i = 0; i < frame.size(); ++i)
    if (frame.kind[i] == Kind::fluid) all.push_back(of(i));
  return all;
}

double speed(const Frame& frame, std::size_t i) {
  const Float3& v = frame.velocity[i];
  return std::hypot(v[0], v[1], v[2]);
}

}  // namespace

StillPressure::StillPressure(const Parameters& p)
    : p_(p), axes_(p.gravity), bottom_(solver::on_level_axes(tank_surface(p), p.gravity).low()[1]) {}

double StillPressure::at(const Float3& place) const {
  const solver::Vec<3> r(place[0], place[1], place[2]);
  double depth = p_.fluid.depth, nearest = std::numeric_limits<double>::infinity();
  for (const auto& seed : p_.fluid.seeds)
    if (const double distance = (r - solver::Vec<3>(seed.x, seed.y, seed.z)).norm(); distance < nearest)
      nearest = distance, depth = seed.depth;
  return p_.fluid.density * p_.gravity.size() * (bottom_ + depth - axes_.height(r));
}

double StillPressure::error(const Frame& frame) const {
  return rms(of_fluid(frame, [&](std::size_t i) { return frame.pressure[i] - at(frame.position[i]); })) /
         (p_.fluid.density * p_.gravity.size() * p_.fluid.depth);
}

double greatest_speed(const Frame& frame) {
  const auto speeds = of_fluid(frame, [&](std::size_t i) { return speed(frame, i); });
  return speeds.empty() ? 0 : *std::ranges::max_element(speeds);
}

double rms_speed(const Frame& frame) {
  return rms(of_fluid(frame, [&](std::size_t i) { return speed(frame, i); }));
}

}  // namespace seiche::apps::validate
