#pragma once
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>
#include <utility>

// Open files that close by themselves, and that no other program inherits unless it is given them.
namespace seiche::render {

/// A file descriptor. A negative number is none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor() { reset(); }

  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }
  void reset() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_ = -1;
};

struct Pipe {
  Descriptor read, write;
};

/// Throws std::system_error.
inline Pipe make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "no pipe");
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// /dev/null, to read nothing from and to write anything to. Throws std::system_error.
inline Descriptor null_device() {
  const int number = open("/dev/null", O_RDWR | O_CLOEXEC);
  if (number < 0) throw std::system_error(errno, std::generic_category(), "/dev/null");
  return Descriptor(number);
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

/// A file without a name. What a program prints to one, nobody has to read while it runs. Throws std::system_error.
inline File temporary_file() {
  File file(std::tmpfile());
  if (!file) throw std::system_error(errno, std::generic_category(), "no temporary file");
  fcntl(fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

}  // namespace seiche::render
