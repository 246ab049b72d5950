#include "apps/common/process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "render/files.hpp"

namespace seiche::apps::compare {
namespace {

constexpr int cannot_start = 127;

// Between fork and exec: nothing here may take memory or a lock.
[[noreturn]] void become(const char* program, char* const* words, int errors, pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(cannot_start);  // it died before the line above
  for (const int number : {SIGINT, SIGTERM}) std::signal(number, SIG_DFL);
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  execv(program, words);
  _exit(cannot_start);
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

}  // namespace

Process::Process(const std::filesystem::path& program, const std::vector<std::string>& arguments) {
  if (!errors_) throw std::system_error(errno, std::generic_category(), "no temporary file");
  std::vector<char*> words;
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const pid_t parent = getpid();
  process_ = fork();
  if (process_ < 0) throw std::system_error(errno, std::generic_category(), program.string());
  if (process_ == 0) become(program.c_str(), words.data(), fileno(errors_.get()), parent);
  // Not by <sys/pidfd.h>, which C++ can't use before glibc 2.37.
  descriptor_ = static_cast<int>(syscall(SYS_pidfd_open, process_, 0));
}

Process::~Process() {
  close(descriptor_);
  if (exit_code()) return;
  signal(SIGKILL);
  waitpid(process_, nullptr, 0);
}

std::optional<int> Process::exit_code() {
  int status = 0;
  if (!code_ && waitpid(process_, &status, WNOHANG) == process_) code_ = code_of(status);
  return code_;
}

void Process::signal(int number) {
  if (!exit_code()) kill(process_, number);
}

std::string Process::errors() const { return render::contents(errors_.get()); }

}  // namespace seiche::apps::compare
