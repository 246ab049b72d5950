#pragma once
#include <span>
#include <string>
#include <vector>

#include "render/system/descriptor.hpp"
#include "render/system/process.hpp"

namespace seiche::render {

/// A program that is fed through its standard input. It runs in a session of its own, so that the terminal's Ctrl-C,
/// meant for this program, doesn't end it with half of its work done.
class Child {
 public:
  /// arguments[0] is looked for on PATH. Throws std::system_error when it can't be started.
  explicit Child(const std::vector<std::string>& arguments);
  ~Child();  ///< closes the input and waits, so that what it has been fed is not lost
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// False when the child no longer reads: it has died. Never raises SIGPIPE.
  bool write(std::span<const unsigned char> bytes);

  /// Closes the input and waits. True when the child then ended with 0.
  bool finish();

  /// What it has printed, to stdout and to stderr; whole after finish().
  std::string output() const;
  std::string errors() const;

 private:
  Process start(const std::vector<std::string>& arguments);

  File output_ = temporary_file(), errors_ = temporary_file();
  Descriptor input_;
  Process process_;
};

}  // namespace seiche::render
