#include "apps/compare/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "apps/common/output_folder.hpp"
#include "apps/compare/runs.hpp"
#include "render/files.hpp"
#include "render/outputs.hpp"
#include "render/picture.hpp"

namespace seiche::apps::compare {
namespace {

constexpr double slack = 1e-6;  // of a frame interval: times are rounded in their list

bool has_failed(const ComparedRun& run) {
  return run.run.record.ending && run.run.record.ending->status == Ending::Status::failed;
}

double last_time(const ComparedRun& run) { return run.frames.back().time; }

// What a picture of all says of where it comes from.
RunInfo info_of_all(const std::vector<ComparedRun>& runs, double interval) {
  RunInfo info = runs.front().run.info;
  info.frame_interval = interval;
  std::string hashes, names;
  for (const ComparedRun& each : runs) {
    hashes += (hashes.empty() ? "" : " ") + each.run.info.scene_hash;
    names += (names.empty() ? "" : "; ") + each.label;
    info.end = std::max(info.end, each.run.info.end);
  }
  info.parameters = fmt::format("# compared: {}\n# those of the first:\n{}", names, info.parameters);
  info.scene_hash = hashes;
  return info;
}

double interval_of(const ComparedRun& run) { return run.run.info.frame_interval; }

// The least multiple of the longest interval that is one of all.
double common_interval(const std::vector<ComparedRun>& runs) {
  constexpr int most = 10;  // pictures left out between two
  const auto shorter = [](const ComparedRun& a, const ComparedRun& b) { return interval_of(a) < interval_of(b); };
  const auto [shortest, longest] = std::minmax_element(runs.begin(), runs.end(), shorter);
  for (int k = 1; k <= most; ++k) {
    const double interval = k * interval_of(*longest);
    const auto fits = [&](const ComparedRun& run) {
      const double frames = interval / interval_of(run);
      return std::abs(frames - std::round(frames)) < slack * frames;
    };
    if (std::all_of(runs.begin(), runs.end(), fits)) return interval;
  }
  throw BadFolder(fmt::format(
      "{} has {:.4g} frames a second and {} {:.4g}: too few of their times are the same to show them side by side; run "
      "one again with the other's output.frame_rate",
      longest->run.folder.string(), 1 / interval_of(*longest), shortest->run.folder.string(),
      1 / interval_of(*shortest)));
}

// The frames of one run, each read when its time comes.
class FrameReader {
 public:
  explicit FrameReader(const ComparedRun& run) : run_(run) {}

  render::PanelFrame at(double time, double interval) {
    const std::size_t number = frame_at(run_, time);
    if (!frame_ || number != number_) {
      const StoredFrame& stored = run_.frames[number];
      frame_ = std::make_shared<const Frame>(render::read_vtu(stored.file, stored.index));
      number_ = number;
    }
    return {frame_, time > last_time(run_) + slack * interval};
  }

 private:
  const ComparedRun& run_;
  std::size_t number_ = 0;
  FramePtr frame_;
};

render::Range united(const std::optional<render::Range>& a, render::Range b) {
  return a ? render::Range{std::min(a->low, b.low), std::max(a->high, b.high)} : b;
}

// Of all pictures; nothing where each has its own. A run that blows up would leave no colour for the others.
std::optional<render::Range> common_range(const std::vector<ComparedRun>& runs, const render::Look& look) {
  if (look.range.source == render::RangeSource::given) return look.range.given;
  const bool all = std::all_of(runs.begin(), runs.end(), has_failed);
  std::optional<render::Range> range;
  for (const ComparedRun& run : runs) {
    if (const auto fixed = render::fixed_range(run.run.info, look)) {
      range = united(range, *fixed);
    } else if (look.range.source == render::RangeSource::run && (all || !has_failed(run))) {
      for (const StoredFrame& each : run.frames)
        range =
            united(range, render::rounded(render::fluid_range(render::read_vtu(each.file, each.index), look.quantity)));
    }
  }
  return range;
}

// Of one picture, by those that still go on.
render::Range range_of(const std::vector<render::PanelFrame>& frames, Quantity quantity) {
  const bool all = std::all_of(frames.begin(), frames.end(), [](const auto& each) { return each.ended; });
  std::optional<render::Range> range;
  for (const render::PanelFrame& each : frames)
    if (all || !each.ended) range = united(range, render::fluid_range(*each.frame, quantity));
  return render::rounded(*range);
}

// Readings are written before the frame that they lead up to.
void check_readings(const ComparedRun& run) {
  if (!run.run.scene.writes(OutputKind::probes) || run.run.info.sensors.empty()) return;
  const auto& times = run.readings.time;
  const double read = times.empty() ? 0 : times.back() + 2 / run.run.scene.output.probe_rate;
  if (read < last_time(run))
    throw BadFolder(fmt::format(
        "{} {}, though the run's frames go on to {:.3g} s; run it again", (run.run.folder / "probes.csv").string(),
        times.empty() ? "has no readings" : fmt::format("ends at {:.3g} s", times.back()), last_time(run)));
}

}  // namespace

ComparedRun compared(std::string label, StoredRun run) {
  ComparedRun all{std::move(label), std::move(run), {}, {}};
  all.frames = stored_frames(all.run);
  if (all.frames.empty())
    throw BadFolder(fmt::format("{} has no VTU files, from which its pictures are drawn; run it with output.vtu = true",
                                all.run.folder.string()));
  check_there(all.frames);
  all.readings = stored_readings(all.run);
  check_readings(all);
  return all;
}

Clock clock_of(const std::vector<ComparedRun>& runs) {
  Clock clock{common_interval(runs), 0, 0};
  for (const ComparedRun& each : runs) {
    const double frames = last_time(each) / clock.interval;
    // One that failed has a picture after its last, to pale in.
    const double last = has_failed(each) ? std::floor(frames + slack) + 1 : std::ceil(frames - slack);
    clock.last = std::max(clock.last, static_cast<long>(last));
    clock.end = std::max(clock.end, has_failed(each) ? last * clock.interval : last_time(each));
  }
  return clock;
}

std::size_t frame_at(const ComparedRun& run, double time) {
  const double latest = time + slack * interval_of(run);
  const auto after = std::upper_bound(run.frames.begin(), run.frames.end(), latest,
                                      [](double t, const StoredFrame& frame) { return t < frame.time; });
  return after == run.frames.begin() ? 0 : static_cast<std::size_t>(after - run.frames.begin()) - 1;
}

render::Variant variant_of(const ComparedRun& run, double end) {
  render::Variant variant{run.run.info, run.label, {}, has_failed(run)};
  variant.run.end = std::min(variant.run.end, end);
  const Statistics& totals = run.run.record.statistics;
  if (totals.leaked > 0) variant.label += fmt::format(", {} leaked", totals.leaked);
  if (totals.spilled > 0) variant.label += fmt::format(", {} spilled", totals.spilled);
  const auto& ending = run.run.record.ending;
  if (!ending)
    variant.message = {fmt::format("unfinished: ends at {:.3g} s", last_time(run))};
  else if (ending->status != Ending::Status::finished)
    variant.message = ending_lines(*ending);
  else if (last_time(run) < end)
    variant.message = {fmt::format("ends at {:.3g} s", last_time(run))};
  return variant;
}

bool draw(const std::vector<ComparedRun>& runs, const render::Look& look, const Pictures& pictures,
          const std::function<bool(long, long)>& progress) {
  const Clock clock = clock_of(runs);
  std::vector<render::Variant> variants;
  std::vector<FrameReader> readers;
  for (const ComparedRun& each : runs) {
    variants.push_back(variant_of(each, clock.end));
    readers.emplace_back(each);
  }
  render::Comparison comparison(std::move(variants), look);
  for (std::size_t i = 0; i < runs.size(); ++i) comparison.record(i, runs[i].readings);
  const auto fixed = common_range(runs, look);
  const std::unique_ptr<render::ImageSink> image_sinks[] = {render::on_thread(render::png_series(pictures.frames)),
                                                            render::on_thread(render::movie(pictures.movie))};
  const RunInfo info = info_of_all(runs, clock.interval);
  for (const auto& image_sink : image_sinks) image_sink->begin(info, look.width, look.height);
  bool going = true;
  for (long number = 0; going && number <= clock.last; ++number) {
    Frame now;
    now.index = number;
    now.time = clock.time(number);
    std::vector<render::PanelFrame> frames;
    for (FrameReader& reader : readers) frames.push_back(reader.at(now.time, clock.interval));
    const render::Image image = comparison.draw(now.time, frames, fixed ? *fixed : range_of(frames, look.quantity));
    for (const auto& image_sink : image_sinks) image_sink->image(image, now);
    going = progress(number, clock.last) || number == clock.last;
  }
  for (const auto& image_sink : image_sinks) image_sink->end();
  return going;
}

}  // namespace seiche::apps::compare
