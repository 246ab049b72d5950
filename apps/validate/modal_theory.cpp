#include "apps/validate/modal_theory.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {

using std::numbers::pi;

double natural_frequency(const Parameters& p, int n) {
  const double k = n * pi / tank_surface(p).size()[0];
  return std::sqrt(p.gravity.size() * k * std::tanh(k * p.fluid.depth));
}

Series roll_elevation(const Parameters& p, double step, double end) {
  const auto& m = p.motion;
  if (m.type != MotionType::harmonic || m.harmonic.of != DegreeOfFreedom::roll || m.start != Start::impulsive ||
      m.harmonic.phase != 0 || m.ramp != 0)
    throw std::invalid_argument("the theory of roll wants motion.type = roll, an impulsive start, no phase, no ramp");
  constexpr int last_mode = 61;  // what is left out is below 0.1 mm for a roll of 1 degree
  const double length = tank_surface(p).size()[0], depth = p.fluid.depth, g = p.gravity.size();
  const double roll = m.harmonic.amplitude * pi / 180, omega = 2 * pi * m.harmonic.frequency;
  Series left;
  for (long i = 0; static_cast<double>(i) * step <= end * (1 + 1e-9); ++i) {
    const double t = static_cast<double>(i) * step;
    double eta = 0;
    for (int n = 1; n <= last_mode; n += 2) {
      const double k = n * pi / length, own = natural_frequency(p, n), c = 4 * length / (n * n * pi * pi);
      const double psi = c * (depth - m.pivot_y - 2 * std::tanh(0.5 * k * depth) / k);
      const double forced = own * own / g * roll * (c * g + psi * omega * omega) / (own * own - omega * omega);
      const double free = (-own * own / g * psi * roll * omega - forced * omega) / own;
      eta += forced * std::sin(omega * t) + free * std::sin(own * t);
    }
    left.t.push_back(t);
    left.y.push_back(eta);
  }
  return left;
}

}  // namespace seiche::apps::validate
