#include "tests/bench/child.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <sstream>
#include <stdexcept>

namespace seiche::bench {
namespace {

constexpr const char* failed = "failed";

void write_all(int to, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t count = write(to, text.data() + at, text.size() - at);
    if (count <= 0) return;
    at += static_cast<std::size_t>(count);
  }
}

std::string read_all(int from) {
  std::string text;
  char part[4096];
  for (ssize_t count; (count = read(from, part, sizeof part)) > 0;) text.append(part, static_cast<std::size_t>(count));
  return text;
}

std::string answer(const std::function<Numbers()>& measure) {
  std::string lines;
  try {
    for (const auto& [name, value] : measure()) lines += fmt::format("{} {:.17g}\n", name, value);
  } catch (const std::exception& error) {
    return fmt::format("{} {}", failed, error.what());
  }
  return lines;
}

}  // namespace

Numbers in_child(const std::function<Numbers()>& measure) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  std::fflush(stdout);  // else the child would print it once more
  const pid_t child = fork();
  if (child == 0) {
    write_all(ends[1], answer(measure));
    _exit(0);
  }
  close(ends[1]);
  const std::string text = child > 0 ? read_all(ends[0]) : "";
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  if (text.empty() || text.starts_with(failed)) throw std::runtime_error(text.empty() ? "no answer" : text);

  Numbers numbers;
  std::istringstream lines(text);
  std::string name;
  for (double value; lines >> name >> value;) numbers[name] = value;
  return numbers;
}

}  // namespace seiche::bench
