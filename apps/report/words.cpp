#include "apps/report/words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "apps/report/curves.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::report {
namespace {

using Number = std::function<double(const Parameters&)>;

std::vector<const Parameters*> parameters_of(const Report& report) {
  std::vector<const Parameters*> all;
  for (const ReportRun& run : report.runs) all.push_back(&run.run.scene.parameters);
  return all;
}

// "5 mm", or "5 to 20 mm" of numbers that vary.
std::string range_text(const Report& report, const Number& number, std::string (*text)(double)) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Parameters* p : parameters_of(report)) {
    low = std::min(low, number(*p));
    high = std::max(high, number(*p));
  }
  std::string least = text(low), most = text(high);
  if (least == most) return most;
  const auto unit_of = [](const std::string& words) { return words.substr(words.find_first_not_of("-+.e0123456789")); };
  const bool one_unit = unit_of(least) == unit_of(most);
  return fmt::format("{}\u00a0to {}", one_unit ? least.substr(0, least.size() - unit_of(least).size()) : least, most);
}

std::string degrees_text(double degrees) { return fmt::format("{:g}°", degrees); }
std::string hertz_text(double hertz) { return fmt::format("{:g}\u00a0Hz", hertz); }

template <class F>
bool same(const Report& report, F value) {
  const auto all = parameters_of(report);
  return std::all_of(all.begin(), all.end(), [&](const Parameters* p) { return value(*p) == value(*all.front()); });
}

std::string motion_text(const Report& report) {
  const auto all = parameters_of(report);
  const Parameters::Motion& motion = all.front()->motion;
  const bool alike = same(report, [](const Parameters& p) { return p.motion.type_name(); }) &&
                     same(report, [](const Parameters& p) { return p.motion.file; }) &&
                     same(report, [](const Parameters& p) { return p.motion.harmonics.size(); });
  if (!alike) return "whose motion varies";
  if (motion.type == MotionType::none) return "at rest";
  if (motion.type == MotionType::file) return fmt::format("that moves as {} says", motion.file);
  if (motion.type == MotionType::harmonics) return fmt::format("that moves in {} harmonics", motion.harmonics.size());
  return fmt::format("that {}s by {} at {}", motion.type_name(),
                     range_text(
                         report, [](const Parameters& p) { return p.motion.harmonic.amplitude; },
                         row(motion.harmonic.of).rotation ? degrees_text : length_text),
                     range_text(
                         report, [](const Parameters& p) { return p.motion.harmonic.frequency; }, hertz_text));
}

// The time and the step are told elsewhere.
std::string cause_of(const Ending& ending) {
  std::string cause = ending.failure ? cause_text(*ending.failure) : "";
  add_error(cause, ending.error);
  return cause;
}

}  // namespace

std::string length_text(double metres) {
  return metres < 0.1 ? fmt::format("{:g}\u00a0mm", 1000 * metres) : fmt::format("{:g}\u00a0m", metres);
}

std::string tank_sentence(const Report& report) {
  const auto all = parameters_of(report);
  const auto has = [&](const Number& number) {
    return std::all_of(all.begin(), all.end(), [&](const Parameters* p) { return number(*p) != 0; });
  };
  const auto length = [&](const Number& number) { return range_text(report, number, length_text); };
  const Number column = [](const Parameters&p) { return p.fluid.column; },
               wave = [](const Parameters&p) { return p.fluid.wave_amplitude; },
               width = [](const Parameters&p) { return tank_surface(p).size()[2]; };
  const std::string depth = length([](const Parameters& p) { return p.fluid.depth; });
  const std::string liquid = has(column)
                                 ? fmt::format("A column of liquid, {} long and {} high,", length(column), depth)
                                 : fmt::format("Liquid {} deep", depth);
  std::string size = length([](const Parameters& p) { return tank_surface(p).size()[0]; }) + " long";
  const std::string height = length([](const Parameters& p) { return tank_surface(p).size()[1]; }) + " high";
  size += has(width) ? fmt::format(", {} and {} wide", height, length(width)) : " and " + height;
  const std::string tank = !same(report, [](const Parameters& p) { return p.tank.closed; }) ? "a"
                           : all.front()->tank.closed                                       ? "a closed"
                                                                                            : "an open";
  const std::string waves = has(wave) ? fmt::format(", with a standing wave of {} at first", length(wave)) : "";
  return fmt::format("{} in {} tank {} {}{}, in {}-D.", liquid, tank, size, motion_text(report), waves,
                     all.front()->dimension());
}

Outcome outcome_of(const ReportRun& run) {
  const auto& ending = run.run.record.ending;
  const std::string time = fmt::format("{:.3g} s", reached(run));
  if (!ending) return {"unfinished", "at " + time, ""};
  switch (ending->status) {
    case Ending::Status::finished:
      return {"survived", time, ""};
    case Ending::Status::interrupted:
      return {"interrupted", "at " + time, ""};
    case Ending::Status::failed:
      break;
  }
  return {"stopped", "at " + time, cause_of(*ending)};
}

std::string outcome_text(const ReportRun& run) {
  const Outcome outcome = outcome_of(run);
  return fmt::format("{} {}{}{}", outcome.what, outcome.time, outcome.reason.empty() ? "" : ": ", outcome.reason);
}

std::string of_all(const Report& report, const std::function<std::string(const ReportRun&)>& text) {
  std::vector<std::string> all;
  for (const ReportRun& run : report.runs) {
    const std::string one = text(run);
    if (!one.empty() && std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace seiche::apps::report
