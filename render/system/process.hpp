#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "render/system/descriptor.hpp"

namespace seiche::render {

/// A program to start, and what it is given.
struct Command {
  std::vector<std::string> words = {};        ///< its name and its arguments
  std::filesystem::path program = {};         ///< its file; empty: words[0] is looked for on PATH
  std::filesystem::path folder = {};          ///< that it works in; empty: where this program does
  std::vector<std::string> environment = {};  ///< "NAME=value" beside this program's own
  std::map<int, int> files = {};              ///< this program's descriptors by the numbers that it finds them under
  bool own_session = false;                   ///< the terminal's Ctrl-C, meant for this program, doesn't reach it
  bool ends_with_us = false;                  ///< told to end with SIGTERM where the thread that started it has ended
};

/// A program at work beside this one. No signal is blocked in it, and SIGINT, SIGTERM and SIGPIPE end it.
class Process {
 public:
  /// Throws std::system_error when it can't be started.
  explicit Process(const Command& command);
  ~Process();  ///< kills it where it is still at work
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// What it ended with, 128 + its number for a signal; nothing while it works.
  std::optional<int> exit_code();

  /// The same, once it has ended.
  int wait();

  void signal(int number);

  /// poll() finds it readable once the process has ended.
  int descriptor() const { return ended_.number(); }

 private:
  std::optional<int> reap(int options);

  pid_t process_ = -1;
  Descriptor ended_;
  std::optional<int> code_;
};

}  // namespace seiche::render
