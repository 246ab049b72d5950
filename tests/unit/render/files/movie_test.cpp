#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>

#include "render/outputs.hpp"
#include "tests/facts.hpp"
#include "tests/unit/render/scratch.hpp"
#include "tests/unit/render/synthetic.hpp"

using namespace seiche;
using namespace seiche::render;

namespace {

// What ffprobe says of a movie: codec_name, width, height, nb_read_frames, duration, ...
std::map<std::string, std::string> probe(const std::filesystem::path& file) {
  const std::string command =
      "ffprobe -v error -count_frames -select_streams v:0 -show_entries "
      "stream=codec_name,width,height,pix_fmt,nb_read_frames,r_frame_rate:format=duration:format_tags "
      "-of default=noprint_wrappers=1 '" +
      file.string() + "' 2>/dev/null";
  std::map<std::string, std::string> found;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(popen(command.c_str(), "r"), pclose);
  char line[4096];
  while (std::fgets(line, sizeof line, out.get())) {
    std::string text = line;
    const auto equals = text.find('=');
    if (equals != std::string::npos) found[text.substr(0, equals)] = text.substr(equals + 1, text.size() - equals - 2);
  }
  return found;
}

int frames_in(const std::filesystem::path& file) { return std::atoi(probe(file)["nb_read_frames"].c_str()); }

constexpr int width = 320, height = 240;

// A white bar that moves over blue; `alpha` of the blue.
Image picture(int number, std::uint8_t alpha = 255) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if ((x + 3 * number) % width < 40)
        image.rgba.insert(image.rgba.end(), {255, 255, 255, 255});
      else
        image.rgba.insert(image.rgba.end(), {20, 60, 200, alpha});
    }
  return image;
}

void write_movie(const std::filesystem::path& file, int frames, std::uint8_t alpha = 255) {
  const auto sink = movie(file);
  sink->begin(test::run_info({}), width, height);
  for (int i = 0; i < frames; ++i) sink->image(picture(i, alpha), Frame{});
  sink->end();
}

// The only child process of another process.
pid_t child_of(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
  pid_t child = 0;
  in >> child;
  return child;
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Starts a process that writes `frames` pictures and then waits to be killed; returns when they are written.
pid_t start_writer(const std::filesystem::path& file, int frames) {
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that the writer's ffmpeg can be waited for
  int ready[2];
  if (pipe(ready) != 0) return -1;
  const pid_t writer = fork();
  if (writer == 0) {
    const auto sink = movie(file);
    sink->begin(test::run_info({}), width, height);
    for (int i = 0; i < frames; ++i) sink->image(picture(i), Frame{});
    if (write(ready[1], "x", 1) != 1) _exit(1);
    for (;;) pause();
  }
  close(ready[1]);
  char byte = 0;
  EXPECT_EQ(read(ready[0], &byte, 1), 1) << "the writer ended early";
  close(ready[0]);
  return writer;
}

// The killed writer, and its ffmpeg, which becomes this process's child.
void wait_for_both() {
  for (int processes = 0; processes < 2; ++processes) EXPECT_GT(waitpid(-1, nullptr, 0), 0);
}

}  // namespace

TEST(Movie, Mp4HasTheFramesTheSizeAndTheDuration) {
  const test::Scratch scratch;
  write_movie(scratch / "a.mp4", 60);
  auto found = probe(scratch / "a.mp4");
  EXPECT_EQ(found["codec_name"], "h264");
  EXPECT_EQ(found["pix_fmt"], "yuv420p");
  EXPECT_EQ(found["width"], "320");
  EXPECT_EQ(found["height"], "240");
  EXPECT_EQ(found["r_frame_rate"], "50/1");
  EXPECT_EQ(found["nb_read_frames"], "60");
  EXPECT_NEAR(std::stod(found["duration"]), 1.2, 0.021);
  EXPECT_EQ(found["TAG:title"], "pan2008");
  EXPECT_EQ(found["TAG:comment"].substr(0, 22), "Software: Seiche 0.1.0");
}

TEST(Movie, Mp4StartsWithItsIndexOnceItIsWhole) {
  const test::Scratch scratch;
  write_movie(scratch / "a.mp4", 60);
  const std::string bytes = bytes_of(scratch / "a.mp4");
  ASSERT_NE(bytes.find("moov"), std::string::npos);
  EXPECT_LT(bytes.find("moov"), bytes.find("mdat")) << "faststart";
  EXPECT_EQ(bytes.find("moof"), std::string::npos) << "no fragments are left";
}

TEST(Movie, WebmAndGif) {
  const test::Scratch scratch;
  write_movie(scratch / "a.webm", 20);
  EXPECT_EQ(probe(scratch / "a.webm")["codec_name"], "vp9");
  EXPECT_EQ(frames_in(scratch / "a.webm"), 20);
  write_movie(scratch / "a.gif", 20);
  EXPECT_EQ(probe(scratch / "a.gif")["codec_name"], "gif");
  EXPECT_EQ(frames_in(scratch / "a.gif"), 20);
}

TEST(Movie, SamePicturesSameBytes) {
  const test::Scratch scratch;
  for (const char* ending : {"mp4", "webm", "gif"}) {
    const std::string a = std::string("a.") + ending, b = std::string("b.") + ending;
    write_movie(scratch / a, 10);
    write_movie(scratch / b, 10);
    EXPECT_FALSE(bytes_of(scratch / a).empty());
    EXPECT_EQ(bytes_of(scratch / a), bytes_of(scratch / b)) << ending;
  }
}

TEST(Movie, TransparentPartsLieOnWhite) {
  const test::Scratch scratch;
  write_movie(scratch / "a.mp4", 1, 0);
  const std::string command = "ffmpeg -v error -i '" + (scratch / "a.mp4").string() +
                              "' -frames:v 1 -f rawvideo -pix_fmt rgb24 '" + (scratch / "a.raw").string() + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const std::string raw = bytes_of(scratch / "a.raw");
  ASSERT_EQ(raw.size(), static_cast<std::size_t>(width * height * 3));
  for (const char byte : raw) ASSERT_GE(static_cast<unsigned char>(byte), 250);
}

TEST(Movie, PlaysAfterItsWriterIsKilled) {
  const test::Scratch scratch;
  for (const char* name : {"a.mp4", "a.webm", "a.gif"}) {
    const pid_t writer = start_writer(scratch / name, 120);
    kill(writer, SIGKILL);
    wait_for_both();
    EXPECT_EQ(frames_in(scratch / name), 120) << name;
  }
}

TEST(Movie, PlaysAfterItsWriterAndFfmpegAreKilled) {
  const test::Scratch scratch;
  const pid_t writer = start_writer(scratch / "a.mp4", 300);
  const pid_t ffmpeg = child_of(writer);
  ASSERT_GT(ffmpeg, 0);
  kill(ffmpeg, SIGKILL);
  kill(writer, SIGKILL);
  wait_for_both();
  // ffmpeg holds back what it has not encoded yet, up to 100 pictures, and the fragment that isn't full.
  EXPECT_GE(frames_in(scratch / "a.mp4"), 150);
}

TEST(Movie, RunsOutsideOfTheTerminalsGroup) {
  const test::Scratch scratch;
  const pid_t writer = start_writer(scratch / "a.mp4", 1);
  const pid_t ffmpeg = child_of(writer);
  EXPECT_GT(ffmpeg, 0);
  EXPECT_NE(getpgid(ffmpeg), getpgid(writer));
  EXPECT_NE(getsid(ffmpeg), getsid(writer));
  kill(writer, SIGKILL);
  wait_for_both();
}

TEST(Movie, SaysThatFfmpegDied) {
  const test::Scratch scratch;
  const auto sink = movie(scratch / "a.mp4");
  sink->begin(test::run_info({}), width, height);
  sink->image(picture(0), Frame{});
  kill(child_of(getpid()), SIGKILL);
  std::string said;
  // The pictures that still fit into the socket are taken; then it is clear that nobody reads.
  for (int i = 0; i < 1000 && said.empty(); ++i) try {
      sink->image(picture(i), Frame{});
    } catch (const std::runtime_error& error) {
      said = error.what();
    }
  EXPECT_TRUE(test::tells(said, {"ffmpeg", "a.mp4"}));
  EXPECT_NO_THROW(sink->end()) << "what is left is closed quietly";
}

TEST(Movie, SaysWhyFfmpegCannotWrite) {
  const test::Scratch scratch;
  std::filesystem::create_directories(scratch / "a.mp4");
  try {
    write_movie(scratch / "a.mp4", 100);
    FAIL() << "written over a folder";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("a.mp4"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("directory"), std::string::npos) << error.what();
  }
}

TEST(Movie, ChecksComeBeforeAnyPicture) {
  EXPECT_NO_THROW(check_movie("a.mp4", 1280, 720));
  EXPECT_NO_THROW(check_movie("a.gif", 641, 361));
  EXPECT_THROW(check_movie("a.mp4", 641, 360), std::invalid_argument);
  EXPECT_THROW(check_movie("a.webm", 640, 361), std::invalid_argument);
  EXPECT_THROW(check_movie("a.avi", 640, 360), std::invalid_argument);
  EXPECT_THROW(check_movie("mp4", 640, 360), std::invalid_argument);
}

TEST(Ffmpeg, IsFoundWithItsEncoders) {
  const Ffmpeg found = find_ffmpeg();
  EXPECT_EQ(found.version.substr(0, 14), "ffmpeg version");
  for (const char* name : {"libx264", "libvpx-vp9", "gif"})
    EXPECT_NE(std::find(found.encoders.begin(), found.encoders.end(), name), found.encoders.end()) << name;
}

TEST(Ffmpeg, MissingNamesThePackage) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  std::string said;
  try {
    check_movie("a.mp4", 640, 360);
  } catch (const NoEncoder& error) {
    said = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(said.find("package ffmpeg"), std::string::npos) << said;
}
