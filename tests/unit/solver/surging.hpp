#pragma once
#include "solver/parameters.hpp"

namespace seiche::test {

/// A tank of 10 x 10 cells (x 5), half full, that surges.
inline Parameters surging(int dimension) {
  Parameters p;
  p.particles.spacing = 0.01;
  p.tank = {.length = 0.1, .height = 0.1, .width = dimension == 3 ? 0.05 : 0, .closed = true};
  p.fluid.depth = 0.05;
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.01, 2}};
  p.threads = 2;
  return p;
}

}  // namespace seiche::test
