#include "apps/common/signals.hpp"

#include <unistd.h>

#include <csignal>

#include "apps/common/exit_codes.hpp"

namespace seiche::apps {
namespace {

// A signal handler can reach nothing but a global.
volatile std::sig_atomic_t signalled = 0;

void on_signal(int) {
  if (signalled) _exit(interrupted);
  signalled = 1;
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;  // A write to the disk or to ffmpeg goes on where it was.
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace

SignalWatch::SignalWatch() {
  signalled = 0;
  handle(on_signal);
}

SignalWatch::~SignalWatch() { handle(SIG_DFL); }

bool SignalWatch::caught() const { return signalled; }

}  // namespace seiche::apps
