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

constexpr const char* to_yuv420 =
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

// Which of the formats' encoders ffmpeg has.
std::vector<std::string> find_encoders() {
  std::vector<std::string> found;
  std::istringstream lines(ask_ffmpeg({"-encoders"}));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream columns(line);  // flags, name, description
    std::string flags, name;
    columns >> flags >> name;
    for (const MovieRow& format : ChoiceTable<MovieFormat>::rows)
      if (format.encoder == name) found.push_back(name);
  }
  return found;
}

}  // namespace

std::vector<std::string> encoder_options(const MovieRow& format) {
  std::istringstream in(fmt::format("{}{}", format.yuv420 ? to_yuv420 : "", format.options));
  return {std::istream_iterator<std::string>(in), {}};
}

Ffmpeg find_ffmpeg() {
  const std::string version = ask_ffmpeg({"-version"});
  return {version.substr(0, version.find('\n')), find_encoders()};
}

void check_size(const MovieRow& format, int width, int height) {
  if (format.yuv420 && (width % 2 != 0 || height % 2 != 0))
    throw std::invalid_argument(
        fmt::format("{} needs an even width and height, not {} x {}; change the size or write a .gif", format.suffix,
                    width, height));
}

void check_movie(const std::filesystem::path& file, int width, int height) {
  const MovieRow& format = format_of(file);
  check_size(format, width, height);
  const auto encoders = find_encoders();
  if (std::find(encoders.begin(), encoders.end(), format.encoder) == encoders.end())
    throw NoEncoder(
        fmt::format("ffmpeg has no encoder {} for {}; install Debian's package ffmpeg", format.encoder, file.string()));
}

}  // namespace seiche::render
