#pragma once
#include <stdexcept>

// What the solver refuses or gives up on.
namespace seiche {

/// The run can't go on: says when, where and why, in one sentence fit for the user.
struct RunFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The parameters don't fit together: which, why, and what to do, in one sentence fit for the user.
struct BadParameters : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

}  // namespace seiche
