#pragma once
#include <sys/types.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace seiche::test {

/// What a program left when it ended.
struct Result {
  int code = 0;  ///< what it exited with; 128 + the signal's number if one ended it
  std::string out, err;
};

/// `seiche` with arguments, started in a folder. Its standard output can be read while it runs.
class Program {
 public:
  /// @param environment "NAME=value" to set beside the test's own
  Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
          const std::vector<std::string>& environment = {});

  /// Reads lines of output until one holds `text`; false if the program's output ends before.
  bool wait_for(const std::string& text);

  void signal(int number);
  Result wait();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, Close>;
  pid_t process_;
  File out_, err_;
  std::string read_;
};

/// Runs it to its end.
Result seiche(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
              const std::vector<std::string>& environment = {});

/// What another program prints.
std::string output_of(const std::string& command);

}  // namespace seiche::test
