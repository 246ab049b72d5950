#pragma once
#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace seiche::apps {

/// A program at work beside this one. The terminal's Ctrl-C doesn't reach it: whoever started it passes on what should.
/// Where this program dies, it is told to end with SIGTERM.
class Process {
 public:
  /// arguments[0] is what the program is called. Throws std::system_error when no process can be made.
  Process(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  ~Process();  ///< kills it where it is still at work
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// What it ended with, 128 + its number for a signal; nothing while it works.
  std::optional<int> exit_code();

  /// poll() finds it readable once the process has ended.
  int descriptor() const { return descriptor_; }

  void signal(int number);

  /// What it has printed to standard error so far.
  std::string errors() const;

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> errors_{std::tmpfile()};
  pid_t process_ = -1;
  int descriptor_ = -1;
  std::optional<int> code_;
};

}  // namespace seiche::apps
