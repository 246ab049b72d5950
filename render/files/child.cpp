#include "render/files/child.hpp"

#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "render/files/file.hpp"

extern char** environ;

namespace seiche::render {
namespace {

std::string without_line_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments) {
  if (!output_ || !errors_) throw std::system_error(errno, std::generic_category(), "no temporary file");
  // A pair of sockets and not a pipe: only a socket can be written to without the risk of SIGPIPE.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "no socket");
  shutdown(ends[1], SHUT_WR);
  input_ = ends[0];

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(output_.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(errors_.get()), STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSID | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  std::vector<char*> words;
  for (const auto& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const int error = posix_spawnp(&process_, words[0], &files, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  close(ends[1]);
  if (error) {
    close(input_);
    throw std::system_error(error, std::generic_category(), arguments[0]);
  }
}

Child::~Child() { finish(); }

bool Child::write(std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(input_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool Child::finish() {
  if (process_ < 0) return succeeded_;
  close(input_);
  int status = 0;
  pid_t ended;
  while ((ended = waitpid(process_, &status, 0)) < 0 && errno == EINTR) continue;
  succeeded_ = ended == process_ && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  process_ = -1;
  return succeeded_;
}

std::string Child::output() const { return without_line_end(contents(output_.get())); }
std::string Child::errors() const { return without_line_end(contents(errors_.get())); }

}  // namespace seiche::render
