#include "tests/cli/program.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace seiche::test {
namespace {

std::string read_all(std::FILE* file) {
  std::string text;
  std::array<char, 4096> part;
  while (const std::size_t count = std::fread(part.data(), 1, part.size(), file)) text.append(part.data(), count);
  return text;
}

}  // namespace

Program::Program(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                 const std::vector<std::string>& environment)
    : err_(std::tmpfile()) {
  int ends[2];
  if (!err_ || pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  std::vector<char*> words{const_cast<char*>(SEICHE_PROGRAM)};
  for (const std::string& word : arguments) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);

  process_ = fork();
  if (process_ == 0) {
    for (const std::string& pair : environment) putenv(const_cast<char*>(pair.c_str()));
    dup2(ends[1], STDOUT_FILENO);
    dup2(fileno(err_.get()), STDERR_FILENO);
    if (chdir(folder.c_str()) == 0) execv(words[0], words.data());
    _exit(127);
  }
  close(ends[1]);
  out_.reset(fdopen(ends[0], "r"));
}

bool Program::wait_for(const std::string& text) {
  char* line = nullptr;
  std::size_t room = 0;
  bool found = false;
  while (!found && getline(&line, &room, out_.get()) >= 0) {
    read_ += line;
    found = std::string(line).find(text) != std::string::npos;
  }
  std::free(line);
  return found;
}

void Program::signal(int number) { kill(process_, number); }

Result Program::wait() {
  Result result;
  result.out = read_ + read_all(out_.get());
  int status = 0;
  waitpid(process_, &status, 0);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  std::rewind(err_.get());
  result.err = read_all(err_.get());
  return result;
}

Result seiche(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
              const std::vector<std::string>& environment) {
  return Program(folder, arguments, environment).wait();
}

std::string output_of(const std::string& command) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(popen(command.c_str(), "r"), pclose);
  return read_all(out.get());
}

}  // namespace seiche::test
