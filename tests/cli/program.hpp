#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "render/system/descriptor.hpp"
#include "render/system/process.hpp"

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
  render::Process start(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                        const std::vector<std::string>& environment);

  render::File out_, err_ = render::temporary_file();
  std::string read_;
  render::Process process_;
};

/// Runs it to its end.
Result seiche(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
              const std::vector<std::string>& environment = {});

/// What another program prints.
std::string output_of(const std::string& command);

}  // namespace seiche::test
