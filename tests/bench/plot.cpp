#include "tests/bench/plot.hpp"

#include <fmt/format.h>

#include "apps/validate/page.hpp"
#include "render/outputs.hpp"

namespace seiche::bench {
namespace {

using render::Curve;

const char* const particles = "fluid particles";

/// A curve over the number of particles, of the runs with as many threads.
template <class F>
Curve curve(const std::string& name, const std::vector<StepCost>& costs, int threads, F value,
            render::Mark mark = render::Mark::line) {
  Curve result{name, {}, {}, mark};
  for (const StepCost& cost : costs) {
    if (cost.threads != threads) continue;
    result.x.push_back(static_cast<double>(cost.fluid));
    result.y.push_back(value(cost));
  }
  return result;
}

/// As many stages as there are colours: the small ones go together.
std::map<std::string, double> grouped(const StepCost& cost) {
  std::map<std::string, double> groups;
  for (const auto& [stage, time] : cost.microseconds) {
    const bool own = stage == "search" || stage == "assembly" || stage == "solve" || stage == "gradient";
    const bool explicit_part = stage == "density" || stage == "explicit";
    groups[own ? stage : explicit_part ? "explicit" : "other"] += time;
  }
  return groups;
}

apps::validate::Chart by_stage(const std::vector<StepCost>& costs, int threads) {
  apps::validate::Chart chart{fmt::format("A step with {} thread{}", threads, threads > 1 ? "s" : ""),
                              particles,
                              "microseconds a particle",
                              {},
                              {render::Scale::decades, render::Scale::decades}};
  for (const auto& each : grouped(costs.at(0)))
    chart.curves.push_back(
        curve(each.first, costs, threads, [&](const StepCost& cost) { return grouped(cost).at(each.first); }));
  chart.curves.push_back(curve(
      "whole", costs, threads, [](const StepCost& cost) { return cost.whole(); }, render::Mark::dashes));
  return chart;
}

template <class F>
apps::validate::Chart by_threads(const char* title, const char* label, const std::vector<StepCost>& costs, F value) {
  return {title,
          particles,
          label,
          {curve("1 thread", costs, 1, value), curve("2 threads", costs, 2, value, render::Mark::points)},
          {render::Scale::decades, render::Scale::linear}};
}

}  // namespace

void plot(const std::filesystem::path& file, const std::vector<StepCost>& costs) {
  const auto iterations = [](const StepCost& cost) { return cost.iterations; };
  const auto bytes = [](const StepCost& cost) { return cost.bytes; };
  const render::Image page = apps::validate::draw_page(
      {by_stage(costs, 1), by_stage(costs, 2), by_threads("Pressure solver", "iterations a step", costs, iterations),
       by_threads("Memory", "resident bytes a particle", costs, bytes)});
  render::write_png(file, page, {});
}

}  // namespace seiche::bench
