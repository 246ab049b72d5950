#include "apps/report/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "apps/report/curves.hpp"

namespace seiche::apps::report {
namespace {

std::string motion_text(const Parameters::Motion& motion) {
  const std::string& type = motion.type;
  if (type == "none") return "at rest";
  if (type == "file") return fmt::format("that moves as {} says", motion.file);
  if (type == "harmonics") return fmt::format("that moves in {} harmonics", motion.harmonics.size());
  const std::string amplitude = type == "roll" ? fmt::format("{:g}°", motion.amplitude) : length_text(motion.amplitude);
  return fmt::format("that {}s by {} at {:g}\u00a0Hz", type, amplitude, motion.frequency);
}

// The run's own sentence begins with the time and the step, which are told elsewhere.
std::string cause(const std::string& reason) {
  const std::size_t colon = reason.find(": ");
  return reason.starts_with("stopped at t = ") && colon != std::string::npos ? reason.substr(colon + 2) : reason;
}

}  // namespace

std::string length_text(double metres) {
  return metres < 0.1 ? fmt::format("{:g}\u00a0mm", 1000 * metres) : fmt::format("{:g}\u00a0m", metres);
}

std::string tank_sentence(const Scene& scene) {
  const Parameters& p = scene.parameters;
  const std::string depth = length_text(p.fluid.depth);
  const std::string liquid =
      p.fluid.column > 0 ? fmt::format("A column of liquid, {} long and {} high,", length_text(p.fluid.column), depth)
                         : fmt::format("Liquid {} deep", depth);
  const std::string length = length_text(p.tank.length), height = length_text(p.tank.height);
  const std::string size = p.tank.width > 0
                               ? fmt::format("{} long, {} high and {} wide", length, height, length_text(p.tank.width))
                               : fmt::format("{} long and {} high", length, height);
  const std::string wave = p.fluid.wave_amplitude > 0 ? fmt::format(", with a standing wave of {} at first",
                                                                    length_text(p.fluid.wave_amplitude))
                                                      : "";
  return fmt::format("{} in {} tank {} {}{}, in {}-D.", liquid, p.tank.closed ? "a closed" : "an open", size,
                     motion_text(p.motion), wave, p.dimension());
}

std::string outcome_text(const ReportRun& run) {
  const auto& ending = run.run.record.ending;
  const std::string time = fmt::format("{:.3g} s", reached(run));
  if (!ending) return fmt::format("still going at {}", time);
  switch (ending->status) {
    case Ending::Status::finished:
      return fmt::format("survived {}", time);
    case Ending::Status::interrupted:
      return fmt::format("interrupted at {}", time);
    case Ending::Status::failed:
      break;
  }
  return fmt::format("stopped at {}: {}", time, cause(ending->reason));
}

std::string of_all(const Report& report, const std::function<std::string(const ReportRun&)>& text) {
  std::vector<std::string> all;
  for (const ReportRun& run : report.runs) {
    const std::string one = text(run);
    if (std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace seiche::apps::report
