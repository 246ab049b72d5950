#pragma once
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "render/image.hpp"
#include "render/look.hpp"
#include "render/motion_marks.hpp"
#include "solver/frame.hpp"
#include "solver/sink.hpp"

// What the program uses of render: checks to make before a run, and sinks to hand frames to. VTK stays in the .cpp
// files.
namespace seiche::render {

/// No OpenGL: says which Debian package to install. The program exits with 4.
struct NoGl : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// No ffmpeg, or it lacks the encoder: says which Debian package to install. The program exits with 5.
struct NoEncoder : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// GL vendor, renderer and version, as in "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6,
/// through OSMesa". Makes a context and drops it. Throws NoGl.
std::string gl_description();

/// Version of VTK, as in "9.1.0".
std::string vtk_version();

/// First line of `ffmpeg -version`, and which of the encoders that Seiche uses (libx264, libvpx-vp9, gif) it has.
/// Throws NoEncoder.
struct Ffmpeg {
  std::string version;
  std::vector<std::string> encoders;
};
Ffmpeg find_ffmpeg();

/// Throws NoEncoder when the movie's format can't be encoded here, std::invalid_argument for an unknown suffix or a
/// size that the format can't have (movie_format.hpp). Call it before the first step.
void check_movie(const std::filesystem::path& file, int width, int height);

/// Takes each finished picture; the same one goes to every sink, so that nothing is drawn twice.
class ImageSink {
 public:
  virtual ~ImageSink() = default;
  virtual void begin(const RunInfo& run, int width, int height) = 0;
  virtual void image(const Image& image, const Frame& frame) = 0;
  virtual void end() = 0;
};

/// folder/000123.png, numbered by Frame::index, with provenance (version, scene, hash, time, step, parameters) in text
/// chunks.
std::unique_ptr<ImageSink> png_series(const std::filesystem::path& folder);

/// A movie streamed to the ffmpeg program while the run goes on; its format by the suffix of its name.
/// A movie that is cut short, even by kill -9, still plays.
std::unique_ptr<ImageSink> movie(const std::filesystem::path& file);

/// The same sink on a thread of its own, so that the next picture is drawn meanwhile; a few may wait for it, in their
/// order. Of a frame it is told index, step and time alone. What it throws comes out of the next image(), or of end().
std::unique_ptr<ImageSink> on_thread(std::unique_ptr<ImageSink> image_sink);

/// Draws each frame once and hands the picture to all sinks. With range "run" frames are kept in a file without a name
/// in `folder` and drawn in end().
std::unique_ptr<Sink> pictures(const Look& look, std::vector<std::unique_ptr<ImageSink>> image_sinks,
                               const std::filesystem::path& folder);

/// folder/vtu/name_000123.vtu, folder/name.pvd and folder/name.vtu.series, both valid after every frame.
std::unique_ptr<Sink> vtu_series(const std::filesystem::path& folder);

/// One frame by itself, with degrees of freedom shown over it.
Image draw_frame(const RunInfo& run, const Look& look, const Frame& frame, const MotionMarks& marks);

/// How a curve is drawn: runs as lines in colours of their own, what they are compared with in black.
enum class Mark { line, dashes, points };

struct Curve {
  std::string name;
  std::vector<double> x, y;
  Mark mark = Mark::line;
};

/// linear: the range takes in 0; decades: logarithmic, for values above 0. Both end at round numbers.
enum class Scale { linear, decades };

struct Scales {
  Scale x = Scale::linear, y = Scale::linear;
};

/// A chart with a legend.
Image draw_curves(const std::vector<Curve>& curves, const std::string& title, const std::string& x_label,
                  const std::string& y_label, int width, int height, Scales scales = {});

/// Throws std::runtime_error when the file can't be written. `text` are tEXt/iTXt chunks: keyword, text.
void write_png(const std::filesystem::path& file, const Image& image,
               const std::vector<std::pair<std::string, std::string>>& text);

}  // namespace seiche::render
