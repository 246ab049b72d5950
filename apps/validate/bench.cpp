#include "apps/validate/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include "apps/common/stopwatch.hpp"
#include "apps/run/loop.hpp"
#include "apps/run/run_info.hpp"
#include "apps/scene/scene_file.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {
namespace {

class Recorder : public Sink {
 public:
  Recorder(Recording& recording, const Look& look) : recording_(recording), look_(look) {}

  void begin(const RunInfo& run) override { run_ = run; }

  void frame(const FramePtr& frame) override {
    auto value = frame->readings.values.begin();
    for (const double time : frame->readings.time)
      for (const Column& column : run_.sensors) {
        Series& series = recording_.sensors[column.name];
        series.t.push_back(time);
        series.y.push_back(*value++);
      }
    if (look_) look_(*frame, run_);
  }

  void end() override {}

 private:
  Recording& recording_;
  const Look& look_;
  RunInfo run_;
};

std::string station_name(std::size_t k) { return fmt::format("station_{}", k); }

// Gauges that a scene names none of stand at the walls; those stay.
void add_gauges(Parameters& p, const std::vector<double>& stations) {
  if (stations.empty()) return;
  auto& gauges = p.sensors.gauge;
  if (gauges.empty()) gauges = {{"left", 0, 0}, {"right", tank_surface(p).high()[0], 0}};
  for (std::size_t k = 0; k < stations.size(); ++k) gauges.push_back({station_name(k), stations[k], 0});
}

// Lines at every 5 % would drown the figures.
Progress::Style style() { return isatty(STDOUT_FILENO) ? Progress::Style::bar : Progress::Style::none; }

}  // namespace

std::string station_column(std::size_t k) { return "eta_" + station_name(k); }

Scene Bench::scene(const std::string& name, const std::vector<std::string>& settings) const {
  std::vector<Override> overrides;
  for (const std::string& setting : settings) overrides.push_back(parse_set(setting));
  return read_scene((scenes_ / (name + ".toml")).string(), overrides);
}

Recording Bench::attempt(const std::string& name, const std::vector<std::string>& settings, const Look& look,
                         const std::vector<double>& stations) {
  Scene scene = this->scene(name, settings);
  scene.parameters.threads = threads_;
  add_gauges(scene.parameters, stations);
  const auto simulation = make_simulation(scene.parameters, 1 / scene.output.probe_rate);

  Recording recording;
  recording.parameters = scene.parameters;
  recording.stations = stations;
  Outputs outputs;
  outputs.add("recorder", std::make_unique<Recorder>(recording, look));
  Progress progress(style());
  const Stopwatch watch;
  const Ending ending = run_loop(*simulation, outputs, run_info(scene), progress, stop_);
  fmt::print("  {} {}: {:g} s in {}{}{}\n", name, fmt::join(settings, " "), ending.time, clock_text(watch.seconds()),
             ending.reason().empty() ? "" : "; ", ending.reason());
  std::fflush(stdout);
  if (ending.status == Ending::Status::interrupted) throw Interrupted();
  recording.statistics = simulation->statistics();
  recording.end = ending.time;
  recording.failure = ending.reason();
  return recording;
}

Recording Bench::run(const std::string& name, const std::vector<std::string>& settings, const Look& look,
                     const std::vector<double>& stations) {
  Recording recording = attempt(name, settings, look, stations);
  if (!recording.failure.empty()) throw std::runtime_error(recording.failure);
  return recording;
}

Series Bench::reference(const std::string& file, const std::string& over, const std::string& column) const {
  return read_series(scenes_ / "reference" / (file + ".csv"), over, column);
}

}  // namespace seiche::apps::validate
