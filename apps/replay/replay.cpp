#include "apps/replay/replay.hpp"

#include <fmt/format.h>

#include "apps/common/output_folder.hpp"
#include "apps/replay/replay_setup.hpp"

namespace fs = std::filesystem;

namespace seiche::apps {
namespace {

// The run's own pictures are kept, whatever may be overwritten.
void check_apart_from_run(const fs::path& path, const OutputFolder& run) {
  for (const fs::path& kept : {run.path, run.frames(), run.path / "vtu"})
    if (fs::weakly_canonical(path) == fs::weakly_canonical(kept))
      throw BadFolder(fmt::format("{} holds the run itself; choose another folder with -o DIR", path.string()));
}

}  // namespace

int replay(const ReplayRequest& request) {
  const Stopwatch watch;
  const Replay replay = set_up(request);
  const SignalWatch signals;
  FrameList list = list_files(request, replay.run, stored_frames, signals);
  const OutputFolder own{request.run, replay.scene.name};
  const PictureFolder folder{request.output.empty() ? own.drawn_again() : request.output, own.scene};
  check_apart_from_run(folder.path, own);
  folder.check(request.overwrite);
  if (request.movie != render::MovieFormat::none)
    render::check_movie(folder.movie(request.movie), replay.scene.look.width, replay.scene.look.height);
  render::gl_description();

  folder.prepare();
  std::vector<std::unique_ptr<render::ImageSink>> image_sinks;
  image_sinks.push_back(render::png_series(folder.path));
  std::vector<MadeFile> made_files{{"pictures", folder.path / ""}};
  if (request.movie != render::MovieFormat::none) {
    image_sinks.push_back(render::movie(folder.movie(request.movie)));
    made_files.emplace_back("movie", folder.movie(request.movie));
  }
  const Replayed ended = draw_again(request, replay, std::move(list), std::move(image_sinks), signals);
  return print_summary(request, ended, watch.seconds(), made_files);
}

}  // namespace seiche::apps
