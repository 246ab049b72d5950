#include "render/system/process.hpp"

#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <csignal>
#include <string>
#include <system_error>

namespace seiche::render {
namespace {

// A shell's script, with what it prints.
struct Shell {
  explicit Shell(const std::string& script, Command command = {})
      : process([&] {
          command.words = {"sh", "-c", script};
          command.files[1] = fileno(output.get());
          return Process(command);
        }()) {}

  std::string text() {
    process.wait();
    std::string text(200, '\0');
    text.resize(static_cast<std::size_t>(pread(fileno(output.get()), text.data(), text.size(), 0)));
    return text;
  }

  File output = temporary_file();
  Process process;
};

TEST(Process, TellsWhatItEndedWith) {
  EXPECT_EQ(Shell("exit 7").process.wait(), 7);
  Shell killed("kill -9 $$");
  EXPECT_EQ(killed.process.wait(), 128 + SIGKILL);
  EXPECT_EQ(killed.process.exit_code(), 128 + SIGKILL) << "asked again";
}

TEST(Process, WorksUntilItsDescriptorIsReadable) {
  Pipe gate = make_pipe();
  Shell shell("read line", {.files = {{0, gate.read.number()}}});
  pollfd end{shell.process.descriptor(), POLLIN, 0};
  EXPECT_EQ(poll(&end, 1, 50), 0);
  EXPECT_FALSE(shell.process.exit_code());
  gate.write.reset();
  EXPECT_EQ(poll(&end, 1, 30000), 1);
  EXPECT_TRUE(shell.process.exit_code());
}

TEST(Process, ThatCannotBeStartedSaysWhy) {
  try {
    const Process process({.words = {"no-such-program"}});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
  EXPECT_THROW(Process({.words = {"sh"}, .folder = "/no/such/folder"}), std::system_error);
}

TEST(Process, HasItsFolderItsEnvironmentAndNoOtherFiles) {
  const Pipe ours = make_pipe();
  const Command command{.folder = "/", .environment = {"SEICHE_X=a b"}, .files = {{5, ours.write.number()}}};
  EXPECT_EQ(Shell("echo $PWD \"$SEICHE_X\"; echo through >&5", command).text(), "/ a b\n");
  std::array<char, 8> through;
  EXPECT_EQ(read(ours.read.number(), through.data(), through.size()), 8);
  EXPECT_EQ(Shell("true >&" + std::to_string(ours.read.number()), {}).process.wait() == 0, false) << "not inherited";
}

TEST(Process, IsKilledWithWhoHoldsIt) {
  Pipe pipe = make_pipe();
  { const Process process({.words = {"sleep", "1000"}, .files = {{1, pipe.write.number()}}}); }
  pipe.write.reset();
  char byte;
  EXPECT_EQ(read(pipe.read.number(), &byte, 1), 0) << "nobody holds the other end any more";
}

TEST(Process, HasNoSignalBlockedAndLeavesOursAsTheyWere) {
  sigset_t interrupts, before, after;
  sigemptyset(&interrupts);
  sigaddset(&interrupts, SIGINT);
  pthread_sigmask(SIG_BLOCK, &interrupts, &before);
  std::signal(SIGPIPE, SIG_IGN);
  EXPECT_EQ(Shell("kill -INT $$; sleep 1").process.wait(), 128 + SIGINT);
  EXPECT_EQ(Shell("kill -PIPE $$; sleep 1").process.wait(), 128 + SIGPIPE);
  pthread_sigmask(SIG_SETMASK, &before, &after);
  EXPECT_TRUE(sigismember(&after, SIGINT));
  EXPECT_FALSE(sigismember(&after, SIGTERM));
  std::signal(SIGPIPE, SIG_DFL);
}

}  // namespace
}  // namespace seiche::render
