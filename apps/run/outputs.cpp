#include "apps/run/outputs.hpp"

#include <future>

#include "apps/common/stopwatch.hpp"
#include "apps/run/probes_csv.hpp"
#include "render/outputs.hpp"

namespace seiche::apps {

void Outputs::add(std::string name, std::unique_ptr<Sink> sink) {
  entries_.push_back({std::move(name), std::move(sink)});
}

void Outputs::begin(const RunInfo& run) {
  for (Entry& entry : entries_) {
    entry.sink->begin(run);
    entry.began = true;
  }
}

void Outputs::frame(const FramePtr& frame) {
  for (Entry& entry : entries_) {
    const Stopwatch watch;
    entry.sink->frame(frame);
    entry.seconds += watch.seconds();
  }
}

std::string Outputs::end() {
  std::string errors;
  for (Entry& entry : entries_) {
    const Stopwatch watch;
    const std::unique_ptr<Sink> sink = std::move(entry.sink);  // and let go of here, on the thread that it worked on
    try {
      if (entry.began) sink->end();
    } catch (const std::exception& error) {
      add_error(errors, error.what());
    }
    entry.seconds += watch.seconds();
  }
  return errors;
}

std::map<std::string, double> Outputs::seconds() const {
  std::map<std::string, double> result;
  for (const Entry& entry : entries_) result[entry.name] = entry.seconds;
  return result;
}

void add_error(std::string& errors, const std::string& another) {
  if (!another.empty() && another != errors) errors += (errors.empty() ? "" : "; ") + another;
}

namespace {

// Kinds that are made of frames, in the order in which each frame is written. Pictures and movies are made of images,
// and the report of what the others left.
struct Maker {
  OutputKind kind;
  std::unique_ptr<Sink> (*sink)(const OutputFolder& folder);
};
const Maker makers[] = {
    {OutputKind::probes, [](const OutputFolder& folder) { return probes_csv(folder.probes()); }},
    {OutputKind::vtu, [](const OutputFolder& folder) { return render::vtu_series(folder.path); }},
};

}  // namespace

Outputs make_outputs(const Scene& scene, const OutputFolder& folder) {
  Outputs outputs;
  for (const Maker& maker : makers)
    if (scene.writes(maker.kind)) outputs.add(std::string(output_row(maker.kind).key), maker.sink(folder));
  if (scene.draws()) {
    std::vector<std::unique_ptr<render::ImageSink>> image_sinks;
    if (scene.writes(OutputKind::pictures)) image_sinks.push_back(render::png_series(folder.frames()));
    if (scene.writes(OutputKind::movie)) image_sinks.push_back(render::movie(folder.movie(scene.output.movie)));
    outputs.add("pictures", render::pictures(scene.look, std::move(image_sinks), folder.path));
  }
  return outputs;
}

void check_outputs(const Scene& scene, const OutputFolder& folder) {
  // Each takes a tenth of a second and more: side by side.
  std::future<void> encoder;
  if (scene.writes(OutputKind::movie))
    encoder = std::async(std::launch::async, render::check_movie, folder.movie(scene.output.movie), scene.look.width,
                         scene.look.height);
  if (scene.draws()) render::gl_description();
  if (encoder.valid()) encoder.get();
}

}  // namespace seiche::apps
