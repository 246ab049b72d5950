#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <span>

#include "render/files/child.hpp"
#include "render/files/codec.hpp"
#include "render/files/file.hpp"
#include "render/files/provenance.hpp"
#include "render/outputs.hpp"

namespace seiche::render {
namespace {

// A movie has no transparency: what is behind is white. Returns the picture's own bytes where it is opaque.
std::span<const unsigned char> on_white(const Image& image, std::vector<unsigned char>& rgbx) {
  std::uint8_t least = 255;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) least &= image.rgba[i];
  if (least == 255) return image.rgba;
  rgbx.resize(image.rgba.size());
  const std::uint8_t* in = image.rgba.data();
  for (std::size_t i = 0; i < rgbx.size(); i += 4, in += 4)
    for (std::size_t c = 0; c < 3; ++c)
      rgbx[i + c] = static_cast<unsigned char>((in[c] * in[3] + 255 * (255 - in[3]) + 127) / 255);
  return rgbx;
}

class Movie : public ImageSink {
 public:
  explicit Movie(const std::filesystem::path& file) : file_(file), format_(format_of(file)) {}

  void begin(const RunInfo& run, int width, int height) override {
    check_size(format_, width, height);
    run_ = run;
  }

  void image(const Image& image, const Frame&) override {
    if (!ffmpeg_) start(image);
    if (!ffmpeg_->write(on_white(image, rgbx_))) fail();
  }

  void end() override {
    if (!ffmpeg_) return;  // without a picture there is no movie
    if (!ffmpeg_->finish()) fail();
    ffmpeg_.reset();
    if (!format_.remux) return;
    ffmpeg_.emplace(std::vector<std::string>{"ffmpeg", "-v", "error", "-y", "-i", "file:" + file_.string(), "-c",
                                             "copy", "-fflags", "+bitexact", "-movflags", "+faststart",
                                             "file:" + partial_name(file_).string()});
    if (!ffmpeg_->finish()) fail();
    ffmpeg_.reset();
    publish(file_);
  }

 private:
  void start(const Image& image) {
    partial_name(file_);  // makes the folder
    const double rate = 1 / run_.frame_interval;
    std::vector<std::string> arguments{"ffmpeg",
                                       "-v",
                                       "error",
                                       "-y",
                                       "-f",
                                       "rawvideo",
                                       "-pixel_format",
                                       "rgb0",  // the fourth byte is ignored
                                       "-video_size",
                                       fmt::format("{}x{}", image.width, image.height),
                                       "-framerate",
                                       fmt::format("{:.9g}", rate),
                                       "-i",
                                       "pipe:0"};
    const auto options = encoder_options(format_);
    arguments.insert(arguments.end(), options.begin(), options.end());
    // bitexact: no version and no random number of ffmpeg's in the file. flush_packets: what is encoded is in the file
    // at once, and not in a buffer that a kill -9 would take along.
    const auto second = std::max(1L, std::lround(rate));
    for (const auto& word :
         {std::string("-g"), fmt::format("{}", second), std::string("-fflags"), std::string("+bitexact"),
          std::string("-flags:v"), std::string("+bitexact"), std::string("-flush_packets"), std::string("1")})
      arguments.push_back(word);
    std::string comment;
    for (const auto& [keyword, value] : provenance(run_)) comment += fmt::format("{}: {}\n", keyword, value);
    for (const auto& word : {std::string("-metadata"), "title=" + run_.name, std::string("-metadata"),
                             "comment=" + comment, "file:" + file_.string()})
      arguments.push_back(word);
    ffmpeg_.emplace(arguments);
  }

  [[noreturn]] void fail() {
    ffmpeg_->finish();
    const std::string why = ffmpeg_->errors();
    ffmpeg_.reset();
    throw std::runtime_error(
        fmt::format("ffmpeg stopped while writing {}: {}", file_.string(), why.empty() ? "it was killed" : why));
  }

  std::filesystem::path file_;
  const MovieRow& format_;
  RunInfo run_;
  std::optional<Child> ffmpeg_;
  std::vector<unsigned char> rgbx_;
};

}  // namespace

std::unique_ptr<ImageSink> movie(const std::filesystem::path& file) { return std::make_unique<Movie>(file); }

}  // namespace seiche::render
