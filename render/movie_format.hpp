#pragma once
#include <array>
#include <filesystem>
#include <string_view>

#include "solver/choice.hpp"

// The formats of movies: names, suffixes, what pages call them and how ffmpeg encodes them.
namespace seiche::render {

enum class MovieFormat { mp4, webm, gif, none };

struct MovieRow : Choice<MovieFormat> {
  std::string_view suffix;      ///< of the file's name, as in ".mp4"
  std::string_view media_type;  ///< as in "video/mp4"
  std::string_view encoder;     ///< ffmpeg's name
  std::string_view options;     ///< of ffmpeg, for a file that can be played at any moment of its making
  bool video = true;            ///< for a player with controls; else an image
  bool remux = false;           ///< copied at the end into a file that plays without reading all of it
  bool yuv420 = true;           ///< colours at half the resolution, which takes an even width and height
};

}  // namespace seiche::render

namespace seiche {

template <>
struct ChoiceTable<render::MovieFormat> {
  using Format = render::MovieFormat;
  static constexpr std::array rows{
      // Half the work of "fast" with CRF 18, for as good a picture (SSIM) in a tenth more bytes.
      // Fragments of a second: whatever kills the program, the file holds all but the last of them.
      render::MovieRow{{Format::mp4, "mp4", "H.264"},
                       ".mp4",
                       "video/mp4",
                       "libx264",
                       "-c:v libx264 -preset veryfast -crf 16.5 -movflags +frag_keyframe+empty_moov+default_base_moof",
                       true,
                       true},
      render::MovieRow{{Format::webm, "webm", "VP9"},
                       ".webm",
                       "video/webm",
                       "libvpx-vp9",
                       "-c:v libvpx-vp9 -crf 24 -b:v 0 -row-mt 1 -deadline good -cpu-used 5"},
      // A palette for each picture: one for all would make ffmpeg hold every picture to the end.
      render::MovieRow{{Format::gif, "gif", "an image that moves, of 256 colours"},
                       ".gif",
                       "image/gif",
                       "gif",
                       "-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none -c:v gif",
                       false,
                       false,
                       false},
      render::MovieRow{{Format::none, "none", "no movie"}, "", "", "", ""},
  };
};

}  // namespace seiche

namespace seiche::render {

constexpr const MovieRow& row_of(MovieFormat format) {
  for (const MovieRow& row : ChoiceTable<MovieFormat>::rows)
    if (row.value == format) return row;
  throw BadParameters("no row of this format");
}

/// By the suffix of a file's name. Throws std::invalid_argument for another one than those of the rows.
const MovieRow& format_of(const std::filesystem::path& file);

}  // namespace seiche::render
