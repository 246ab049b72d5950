#pragma once
#include <stdexcept>

// Errors in what the user gave; each ends the program with its own exit code.
namespace seiche::apps {

/// Everything that is wrong with a scene or a file that it names, one message a line, each with file:line:column or the
/// flag at fault.
struct BadScene : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A folder, or what is in it, can't be used: why, and what to do.
struct BadFolder : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace seiche::apps
