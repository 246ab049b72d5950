#include "render/files/child.hpp"

#include <sys/socket.h>

#include <cerrno>
#include <system_error>

#include "render/files/file.hpp"

namespace seiche::render {
namespace {

std::string without_line_end(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments) : process_(start(arguments)) {}

Process Child::start(const std::vector<std::string>& arguments) {
  // A pair of sockets and not a pipe: only a socket can be written to without the risk of SIGPIPE.
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "no socket");
  input_ = Descriptor(ends[0]);
  const Descriptor other_end(ends[1]);
  shutdown(other_end.number(), SHUT_WR);
  return Process({.words = arguments,
                  .files = {{0, other_end.number()}, {1, fileno(output_.get())}, {2, fileno(errors_.get())}},
                  .own_session = true});
}

Child::~Child() { finish(); }

bool Child::write(std::span<const unsigned char> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = send(input_.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
  return true;
}

bool Child::finish() {
  input_.reset();
  return process_.wait() == 0;
}

std::string Child::output() const { return without_line_end(contents(output_.get())); }
std::string Child::errors() const { return without_line_end(contents(errors_.get())); }

}  // namespace seiche::render
