#pragma once
#include <functional>
#include <map>
#include <string>

namespace seiche::bench {

/// Figures by name.
using Numbers = std::map<std::string, double>;

/// What `measure` finds in a process of its own, so that no measurement sees the heap or the threads of another. The
/// caller must not have had OpenMP threads. Throws std::runtime_error with what the measurement threw.
Numbers in_child(const std::function<Numbers()>& measure);

}  // namespace seiche::bench
