#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seiche::render {

/// How ffmpeg encodes a movie whose name has a certain ending.
struct Codec {
  std::string ending;                ///< as in ".mp4"
  std::string encoder;               ///< ffmpeg's name
  std::vector<std::string> options;  ///< for a file that can be played at any moment of its making
  bool remux = false;                ///< copied at the end into a file that plays without reading all of it
  bool even = true;                  ///< needs an even width and height
};

const std::vector<Codec>& codecs();

/// Throws std::invalid_argument for an unknown ending.
const Codec& codec_of(const std::filesystem::path& file);

/// Throws std::invalid_argument for a size that the codec refuses.
void check_size(const Codec& codec, int width, int height);

}  // namespace seiche::render
