#include "render/files/codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "render/files/child.hpp"
#include "render/outputs.hpp"

namespace seiche::render {
namespace {

std::vector<std::string> words(const char* line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

constexpr const char* yuv =
    "-vf scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
    " -colorspace bt709 -color_primaries bt709 -color_trc bt709 -color_range tv ";

// stdout of ffmpeg with the given options.
std::string ask_ffmpeg(const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"ffmpeg", "-hide_banner"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  try {
    Child ffmpeg(arguments);
    if (ffmpeg.finish()) return ffmpeg.output();
    throw NoEncoder(
        fmt::format("the program ffmpeg doesn't run ({}); install Debian's package ffmpeg anew", ffmpeg.errors()));
  } catch (const std::system_error& error) {
    throw NoEncoder(fmt::format("the program ffmpeg can't be started ({}); install Debian's package ffmpeg",
                                error.code().message()));
  }
}

// Which of the codecs' encoders ffmpeg has.
std::vector<std::string> find_encoders() {
  std::vector<std::string> found;
  std::istringstream lines(ask_ffmpeg({"-encoders"}));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);  // flags, name, description
    std::string flags, name;
    columns >> flags >> name;
    for (const Codec& codec : codecs())
      if (codec.encoder == name) found.push_back(name);
  }
  return found;
}

}  // namespace

const std::vector<Codec>& codecs() {
  static const std::vector<Codec> all{
      // Half the work of "fast" with CRF 18, for as good a picture (SSIM) in a tenth more bytes.
      // Fragments of a second: whatever kills the program, the file holds all but the last of them.
      {".mp4", "libx264",
       words(fmt::format(
                 "{}-c:v libx264 -preset veryfast -crf 16.5 -movflags +frag_keyframe+empty_moov+default_base_moof", yuv)
                 .c_str()),
       true, true},
      {".webm", "libvpx-vp9",
       words(fmt::format("{}-c:v libvpx-vp9 -crf 24 -b:v 0 -row-mt 1 -deadline good -cpu-used 5", yuv).c_str()), false,
       true},
      // A palette for each picture: one for all would make ffmpeg hold every picture to the end.
      {".gif", "gif",
       words("-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none -c:v gif"), false,
       false}};
  return all;
}

const Codec& codec_of(const std::filesystem::path& file) {
  for (const Codec& codec : codecs())
    if (file.extension() == codec.ending) return codec;
  throw std::invalid_argument(fmt::format("{}: the ending of a movie's name is .mp4, .webm or .gif", file.string()));
}

Ffmpeg find_ffmpeg() {
  const std::string version = ask_ffmpeg({"-version"});
  return {version.substr(0, version.find('\n')), find_encoders()};
}

void check_size(const Codec& codec, int width, int height) {
  if (codec.even && (width % 2 != 0 || height % 2 != 0))
    throw std::invalid_argument(
        fmt::format("{} needs an even width and height, not {} x {}; change the size or write a .gif", codec.ending,
                    width, height));
}

void check_movie(const std::filesystem::path& file, int width, int height) {
  const Codec& codec = codec_of(file);
  check_size(codec, width, height);
  const auto encoders = find_encoders();
  if (std::find(encoders.begin(), encoders.end(), codec.encoder) == encoders.end())
    throw NoEncoder(
        fmt::format("ffmpeg has no encoder {} for {}; install Debian's package ffmpeg", codec.encoder, file.string()));
}

}  // namespace seiche::render
