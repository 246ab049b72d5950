#include "tests/cli/program.hpp"

#include <array>
#include <cstdio>
#include <memory>

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
    : process_(start(folder, arguments, environment)) {}

render::Process Program::start(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                               const std::vector<std::string>& environment) {
  std::vector<std::string> words{SEICHE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  render::Pipe pipe = render::make_pipe();
  out_.reset(fdopen(pipe.read.release(), "r"));
  return render::Process({.words = words,
                          .folder = folder,
                          .environment = environment,
                          .files = {{1, pipe.write.number()}, {2, fileno(err_.get())}}});
}

bool Program::wait_for(const std::string& text) {
  std::array<char, 256> part{};
  const std::size_t begin = read_.size();
  bool found = false;
  while (!found && std::fgets(part.data(), part.size(), out_.get())) {
    read_ += part.data();
    found = read_.find(text, begin) != std::string::npos;
  }
  return found;
}

void Program::signal(int number) { process_.signal(number); }

Result Program::wait() {
  Result result;
  result.out = read_ + read_all(out_.get());
  result.code = process_.wait();
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
