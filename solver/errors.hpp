#pragma once
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "solver/frame.hpp"

// What the solver refuses or gives up on.
namespace seiche {

/// When, why and where a run can't go on.
struct Failure {
  struct Particle {
    Kind kind = Kind::fluid;
    std::uint32_t id = 0;
    std::vector<double> position;  ///< one value a dimension [m]; not finite where that is what is wrong
  };

  double time = 0;                     ///< simulated [s]
  long step = 0;                       ///< that it broke in
  std::string cause;                   ///< as in "the speed of 12 m/s is beyond the limit of 9 m/s"
  std::string detail = {};             ///< figures or a likely reason of the cause; may be empty
  std::optional<Particle> place = {};  ///< the particle at fault, where there is one
};

/// As in "fluid".
const char* name(Kind kind);

/// The cause with its detail and place, as in "the speed of ... (fluid particle 550 at x = 0.1 m, y = 0.2 m)".
std::string cause_text(const Failure& failure);

/// All of it in one sentence fit for the user, as in "stopped at t = 0.0190 s, step 36: the speed of ...".
std::string sentence(const Failure& failure);

/// The run can't go on; what() is the failure's sentence.
struct RunFailure : std::runtime_error {
  explicit RunFailure(Failure why) : std::runtime_error(sentence(why)), failure(std::move(why)) {}
  Failure failure;
};

/// The parameters don't fit together: which, why, and what to do, in one sentence fit for the user.
struct BadParameters : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace seiche
