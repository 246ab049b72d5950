#include <fmt/format.h>

#include <algorithm>

#include "apps/common/output_folder.hpp"
#include "apps/replay/replay.hpp"
#include "apps/replay/replay_setup.hpp"
#include "render/files.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

constexpr std::size_t pictures_ahead = 3;  // decoded, and waiting for the encoder

// A picture that is decoded; of its frame only index and time are known.
struct Picture {
  long index = 0;
  double time = 0;
  fs::path file;
  render::Image image;
};
using PicturePtr = std::shared_ptr<const Picture>;

PicturePtr read_picture(FrameList& list, const std::stop_token& stop) {
  const auto next = list.next(stop);
  if (!next) return {};
  return std::make_shared<Picture>(Picture{next->index, next->time, next->file, render::read_png(next->file)});
}

// Hands pictures to the movie as they are.
class PictureEncoder {
 public:
  explicit PictureEncoder(const fs::path& file) : movie_(render::movie(file)) {}

  void begin(const RunInfo& run) { run_ = run; }

  // The first picture settles the size.
  void frame(const PicturePtr& picture) {
    const render::Image& image = picture->image;
    if (width_ == 0) {
      movie_->begin(run_, image.width, image.height);
      std::tie(width_, height_) = std::tie(image.width, image.height);
    }
    if (image.width != width_ || image.height != height_)
      throw std::runtime_error(fmt::format("{} has {} x {} pixels, the pictures before it {} x {}",
                                           picture->file.string(), image.width, image.height, width_, height_));
    Frame frame;
    std::tie(frame.index, frame.time) = std::tie(picture->index, picture->time);
    movie_->image(image, frame);
  }

  std::string end() {
    try {
      if (width_ > 0) movie_->end();
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  }

 private:
  std::unique_ptr<render::ImageSink> movie_;
  RunInfo run_;
  int width_ = 0, height_ = 0;
};

Replayed encode_again(const ReplayRequest& request, const Replay& replay, FrameList list, const fs::path& file,
                      const SignalWatch& signals) {
  const Span span = span_of(request, list, replay.run.info);
  PictureEncoder encoder(file);
  ReadAhead<PicturePtr> ahead([&](const std::stop_token& stop) { return read_picture(list, stop); }, pictures_ahead);
  Progress progress(Progress::suitable(request.quiet));
  return replay_loop(ahead, encoder, replay.info, span, progress, [&] { return signals.caught(); });
}

void check_file(const fs::path& file, const StoredRun& run, bool overwrite) {
  const OutputFolder own{run.folder, run.scene.name};
  if (!run.record.ending && fs::weakly_canonical(file) == fs::weakly_canonical(own.movie(run.scene.output.movie)))
    throw BadFolder(fmt::format("{} is being written by the run; choose another name with -o FILE", file.string()));
  if (fs::is_directory(file))
    throw BadFolder(fmt::format("{} is a folder; name the movie's file with -o FILE", file.string()));
  if (fs::exists(file) && !overwrite)
    throw BadFolder(
        fmt::format("{} exists; choose another name with -o FILE, or replace it with --overwrite", file.string()));
}

std::vector<StoredFrame> asked_for(const ReplayRequest& request, std::vector<StoredFrame> all) {
  std::erase_if(all, [&](const StoredFrame& each) { return !request.frames.holds(each); });
  return all;
}

// Whether the run has pictures, or will have. Where one is missing, all are drawn anew, or can't be.
bool has_pictures(const ReplayRequest& request, const StoredRun& run) {
  if (request.latest && !run.record.ending) return run.scene.writes(OutputKind::pictures);
  const auto pictures = asked_for(request, listed_pictures(run)), frames = asked_for(request, stored_frames(run));
  if (!std::ranges::includes(pictures, frames, {}, &StoredFrame::index, &StoredFrame::index)) return false;
  const auto apart = [](const StoredFrame& a, const StoredFrame& b) { return b.index != a.index + 1; };
  const auto gap = std::adjacent_find(pictures.begin(), pictures.end(), apart);
  if (gap != pictures.end())
    throw BadFolder(
        fmt::format("the picture after {} isn't there, and without VTU files it can't be drawn anew; "
                    "choose others with --frames A:B",
                    gap->file.string()));
  return !pictures.empty();
}

}  // namespace

int replay_movie(const ReplayRequest& request) {
  const Stopwatch watch;
  const Replay replay = set_up(request);
  const OutputFolder own{request.run, replay.scene.name};
  const fs::path file = request.output.empty()
                            ? PictureFolder{own.drawn_again(), own.scene}.movie(render::MovieFormat::mp4)
                            : request.output;
  const SignalWatch signals;
  const bool decoded = request.look.empty() && has_pictures(request, replay.run);
  FrameList list = list_files(request, replay.run, decoded ? listed_pictures : stored_frames, signals);
  check_file(file, replay.run, request.overwrite);
  const render::Look& look = replay.scene.look;
  render::check_movie(file, look.width, look.height);

  // One that is replaced stays until the other is whole.
  const bool replaced = fs::exists(file);
  const fs::path made = replaced ? render::partial_name(file) : file;
  Replayed ended;
  if (decoded) {
    ended = encode_again(request, replay, std::move(list), made, signals);
  } else {
    render::gl_description();
    std::vector<std::unique_ptr<render::ImageSink>> image_sinks;
    image_sinks.push_back(render::movie(made));
    ended = draw_again(request, replay, std::move(list), std::move(image_sinks), signals);
  }
  if (!replaced) return print_summary(request, ended, watch.seconds(), {{"movie", file}});
  const bool whole = ended.error.empty() && !ended.interrupted;
  if (whole) {
    render::publish(file);
  } else {
    fs::remove(made);
    ended.frames = 0;  // of those drawn none is kept
  }
  return print_summary(request, ended, watch.seconds(), {{whole ? "movie" : "as before", file}});
}

}  // namespace seiche::apps
