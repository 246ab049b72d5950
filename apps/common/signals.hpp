#pragma once

namespace seiche::apps {

/// While one lives, the first SIGINT or SIGTERM is noted instead of ending the program; a second one ends it at once.
class SignalWatch {
 public:
  SignalWatch();
  ~SignalWatch();
  SignalWatch(const SignalWatch&) = delete;
  SignalWatch& operator=(const SignalWatch&) = delete;

  bool caught() const;
};

}  // namespace seiche::apps
