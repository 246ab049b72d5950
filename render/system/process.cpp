#include "render/system/process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <string_view>
#include <system_error>

namespace seiche::render {
namespace {

// Signals wait while one lives, so that none is handled between fork and exec.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

 private:
  sigset_t before_;
};

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> result;
  for (const std::string& word : words) result.push_back(const_cast<char*>(word.c_str()));
  result.push_back(nullptr);
  return result;
}

std::vector<std::string> environment_with(const std::vector<std::string>& more) {
  const auto name = [](std::string_view pair) { return pair.substr(0, pair.find('=')); };
  std::vector<std::string> all = more;
  for (char** pair = environ; *pair; ++pair) {
    bool replaced = false;
    for (const std::string& each : more) replaced |= name(each) == name(*pair);
    if (!replaced) all.emplace_back(*pair);
  }
  return all;
}

// All that starting takes, made before fork: after it nothing may take memory or a lock.
struct Start {
  const char* program;
  const char* folder;  // or none
  std::vector<char*> words, environment;
  std::vector<std::pair<int, int>> files;  // the child's number and ours, out of the way of the child's numbers
  bool own_session, ends_with_us;
  pid_t parent;
};

bool prepare(const Start& start) {
  if (start.own_session && setsid() < 0) return false;
  if (start.ends_with_us) {
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != start.parent) _exit(127);  // it ended before the line above
  }
  for (const auto& [number, ours] : start.files)
    if (dup2(ours, number) < 0) return false;
  if (start.folder && chdir(start.folder) != 0) return false;
  for (const int number : {SIGINT, SIGTERM, SIGPIPE}) std::signal(number, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  return sigprocmask(SIG_SETMASK, &none, nullptr) == 0;
}

// Says what went wrong in the pipe, which exec closes.
[[noreturn]] void become(const Start& start, int report) {
  if (prepare(start)) execvpe(start.program, start.words.data(), start.environment.data());
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(report, &error, sizeof error);
  _exit(127);
}

// 0 where it has started.
int error_in(int pipe) {
  int error = 0;
  while (read(pipe, &error, sizeof error) < 0 && errno == EINTR) continue;
  return error;
}

// Above all numbers that a child is given.
Descriptor out_of_the_way(int number, const std::map<int, int>& files) {
  const int above = files.empty() ? 0 : files.rbegin()->first + 1;
  const int copy = fcntl(number, F_DUPFD_CLOEXEC, above);
  if (copy < 0) throw std::system_error(errno, std::generic_category(), "no descriptor");
  return Descriptor(copy);
}

}  // namespace

Process::Process(const Command& command) {
  const std::string program = command.program.empty() ? command.words.at(0) : command.program.string();
  const std::vector<std::string> environment = environment_with(command.environment);
  std::vector<Descriptor> copies;
  Start start{program.c_str(),
              command.folder.empty() ? nullptr : command.folder.c_str(),
              pointers(command.words),
              pointers(environment),
              {},
              command.own_session,
              command.ends_with_us,
              getpid()};
  for (const auto& [number, ours] : command.files)
    start.files.emplace_back(number, copies.emplace_back(out_of_the_way(ours, command.files)).number());
  Pipe pipe = make_pipe();
  Descriptor report = out_of_the_way(pipe.write.number(), command.files);
  pipe.write.reset();
  {
    const BlockedSignals blocked;
    process_ = fork();
    if (process_ < 0) throw std::system_error(errno, std::generic_category(), program);
    if (process_ == 0) become(start, report.number());
  }
  report.reset();
  if (const int error = error_in(pipe.read.number())) {
    wait();
    throw std::system_error(error, std::generic_category(), program);
  }
  // Not by <sys/pidfd.h>, which C++ can't use before glibc 2.37.
  ended_ = Descriptor(static_cast<int>(syscall(SYS_pidfd_open, process_, 0)));
}

Process::~Process() {
  signal(SIGKILL);
  wait();
}

std::optional<int> Process::exit_code() { return reap(WNOHANG); }

int Process::wait() { return *reap(0); }

std::optional<int> Process::reap(int options) {
  if (code_) return code_;
  int status = 0;
  pid_t ended;
  while ((ended = waitpid(process_, &status, options)) < 0 && errno == EINTR) continue;
  if (ended == process_) code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (ended < 0) code_ = 127;  // somebody else has reaped it
  return code_;
}

void Process::signal(int number) {
  if (!exit_code()) kill(process_, number);
}

}  // namespace seiche::render
