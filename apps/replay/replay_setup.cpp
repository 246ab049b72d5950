#include "apps/replay/replay_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <mutex>

#include "apps/common/exit_codes.hpp"
#include "apps/common/output_folder.hpp"
#include "apps/replay/replay_frames.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/look_change.hpp"
#include "render/check_look.hpp"
#include "render/picture.hpp"

namespace seiche::apps {
namespace {

constexpr std::size_t frames_ahead = 3;  // read, and waiting to be drawn
constexpr std::chrono::milliseconds poll_interval{500};

bool names(const ReplayRequest& request, const std::string& key) {
  return std::any_of(request.look.begin(), request.look.end(), [&](const Override& each) { return each.key == key; });
}

// Curves need probes.csv; without it they are left out, unless they are asked for.
void check_curves(const ReplayRequest& request, const StoredRun& run, Scene& scene) {
  const bool there = !run.record.ending || std::filesystem::exists(OutputFolder{run.folder, scene.name}.probes());
  if ((scene.writes(OutputKind::probes) && there) || !scene.look.draws_curves()) return;
  if (names(request, "look.curves"))
    throw BadFolder(fmt::format(
        "{} has no readings to draw curves of: {}", run.folder.string(),
        scene.writes(OutputKind::probes) ? "its probes.csv isn't there" : "it was run with output.probes = false"));
  scene.look.curves.emplace();
}

// Waits a moment, or until the token or Ctrl-C says not to.
FrameList::Wait patience(const SignalWatch& signals) {
  return [&signals](const std::stop_token& stop) {
    std::mutex mutex;
    std::unique_lock lock(mutex);
    std::condition_variable_any changed;
    changed.wait_for(lock, stop, poll_interval, [] { return false; });
    return !stop.stop_requested() && !signals.caught();
  };
}

// The range that holds every frame of the run; Ctrl-C makes it a shorter search, and nothing is drawn.
render::Range range_of_run(const StoredRun& run, Quantity quantity, const SignalWatch& signals) {
  std::optional<render::Range> whole;
  ReplayFrames frames(run, {run, stored_frames, {}});
  ReadAhead<FramePtr> ahead([&](const std::stop_token& stop) { return frames.next(stop); }, frames_ahead);
  while (const FramePtr frame = signals.caught() ? nullptr : ahead.next()) {
    const render::Range range = render::fluid_range(*frame, quantity);
    if (!whole) whole = range;
    whole = render::Range{std::min(whole->low, range.low), std::max(whole->high, range.high)};
  }
  return render::rounded(whole.value_or(render::Range{}));
}

// Why there is nothing to show.
std::string why_nothing(const StoredRun& run, FrameList::Scan scan) {
  const auto all = scan(run);
  if (!all.empty())
    return fmt::format("none of the frames in {} is among those asked for: it has {} to {}, from {:.6g} to {:.6g} s",
                       run.folder.string(), all.front().index, all.back().index, all.front().time, all.back().time);
  if (!run.scene.writes(OutputKind::vtu))
    return fmt::format("{} has no VTU files to draw from: it was run with output.vtu = false", run.folder.string());
  return fmt::format("{} has no frames{}", run.folder.string(),
                     run.record.ending ? "" : " yet; --latest waits for them");
}

}  // namespace

Replay set_up(const ReplayRequest& request) {
  Replay replay{read_run(request.run), {}, {}};
  replay.scene = replay.run.scene;
  change_look(replay.scene, request.look);
  check_curves(request, replay.run, replay.scene);
  render::check_look(replay.scene.look);
  render::check_dimension(replay.scene.look, replay.scene.parameters.dimension());
  if (request.latest && replay.scene.look.range.source == render::RangeSource::run)
    throw std::invalid_argument(
        "--latest draws frames as they come, and the range \"run\" needs all of them; give --range scene, frame or "
        "min,max");
  if (request.frames.from > request.frames.to)
    throw std::invalid_argument(
        fmt::format("--from {:g} s is after --to {:g} s", request.frames.from, request.frames.to));
  replay.info = run_info(replay.scene);
  const double rate = request.fps > 0 ? request.fps : std::max(request.speed, 0.0) / replay.info.frame_interval;
  if (rate > 0) replay.info.frame_interval = 1 / rate;
  return replay;
}

FrameList list_files(const ReplayRequest& request, const StoredRun& run, FrameList::Scan scan,
                     const SignalWatch& signals) {
  FrameList list(run, scan, request.frames, request.latest ? patience(signals) : FrameList::Wait{});
  const bool to_come =
      request.latest && !run.record.ending && (scan != stored_frames || run.scene.writes(OutputKind::vtu));
  if (list.found().empty() && !to_come) throw BadFolder(why_nothing(run, scan));
  check_there(list.found());
  return list;
}

Span span_of(const ReplayRequest& request, const FrameList& list, const RunInfo& run) {
  const auto& found = list.found();
  Span span{std::max(request.frames.from, 0.0), std::min(request.frames.to, run.end), 0};
  if (!request.latest) {
    span = {found.front().time, found.back().time, found.back().index};
  } else {
    span.last = std::min(request.frames.last, std::lround(span.end / run.frame_interval));
  }
  return span;
}

Replayed draw_again(const ReplayRequest& request, const Replay& replay, FrameList list,
                    std::vector<std::unique_ptr<render::ImageSink>> image_sinks, const SignalWatch& signals) {
  for (auto& image_sink : image_sinks) image_sink = render::on_thread(std::move(image_sink));
  render::Look look = replay.scene.look;
  const bool whole = look.range.source == render::RangeSource::run && render::classes_of(look.quantity).empty();
  if (whole) look.range = {render::RangeSource::given, range_of_run(replay.run, look.quantity, signals)};
  const Span span = span_of(request, list, replay.run.info);
  ReplayFrames frames(replay.run, std::move(list));
  if (whole) frames.hand_out_all_readings();
  Outputs outputs;
  outputs.add("pictures", render::pictures(look, std::move(image_sinks), replay.run.folder));
  ReadAhead<FramePtr> ahead([&](const std::stop_token& stop) { return frames.next(stop); }, frames_ahead);
  Progress progress(Progress::suitable(request.quiet));
  return replay_loop(ahead, outputs, replay.info, span, progress, [&] { return signals.caught(); });
}

int print_summary(const ReplayRequest& request, const Replayed& ended, double seconds,
                  const std::vector<MadeFile>& made_files) {
  const bool bad = !ended.error.empty();
  std::string text = fmt::format("{}: {} frame{} in {}\n",
                                 bad                 ? fmt::format("{}\nKept", ended.error)
                                 : ended.interrupted ? "Interrupted"
                                                     : "Done",
                                 ended.frames, ended.frames == 1 ? "" : "s", clock_text(seconds));
  for (const auto& [what, path] : made_files)
    if (std::filesystem::exists(path)) text += fmt::format("  {:<9} {}\n", what, path.string());
  if (bad) fmt::print(stderr, "seiche: {}", text);
  if (!bad && !request.quiet) fmt::print("{}", text);
  return bad ? failed : ended.interrupted ? interrupted : done;
}

}  // namespace seiche::apps
