#pragma once
#include "solver/frame.hpp"
#include "solver/statistics.hpp"

namespace seiche {

/// A tank of particles that can be stepped through time.
class Simulation {
 public:
  virtual ~Simulation() = default;

  /// Takes one step, of a length by the rule of equation (18), such that some step ends exactly at `until`:
  /// what is left to `until` is split into equal steps. Throws RunFailure; the state is then the one that the run broke
  /// off in, whose values may not be finite.
  virtual void step(double until) = 0;

  virtual double time() const = 0;
  virtual const Statistics& statistics() const = 0;

  /// The state now, as frame number `index`, with the sensor readings taken since the last call.
  virtual FramePtr frame(long index) = 0;
};

}  // namespace seiche
