#pragma once
#include <algorithm>

#include "solver/motion/motion.hpp"
#include "solver/particles/state.hpp"

namespace seiche::solver {

/// The state as a Frame: float32, in id order.
template <int D>
std::shared_ptr<Frame> snapshot(const State<D>& s, double n0, const Motion& motion) {
  auto frame = std::make_shared<Frame>();
  frame->step = s.step;
  frame->time = s.time;
  frame->pose = motion.state(s.time);
  const std::size_t n = s.size();
  std::vector<int> order(n);
  for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<int>(i);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return s.id[a] < s.id[b]; });
  frame->position.resize(n);
  frame->velocity.resize(n);
  frame->pressure.resize(n);
  frame->number_density.resize(n);
  frame->kind.resize(n);
  frame->free_surface.resize(n);
  frame->id.resize(n);
  for (std::size_t k = 0; k < n; ++k) {
    const int i = order[k];
    for (int a = 0; a < D; ++a) {
      frame->position[k][a] = static_cast<float>(s.position[i][a]);
      frame->velocity[k][a] = static_cast<float>(s.velocity[i][a]);
    }
    frame->pressure[k] = static_cast<float>(s.pressure[i]);
    frame->number_density[k] = static_cast<float>(s.density[i] / n0);
    frame->kind[k] = s.kind[i];
    frame->free_surface[k] = s.surface[i];
    frame->id[k] = s.id[i];
  }
  return frame;
}

}  // namespace seiche::solver
