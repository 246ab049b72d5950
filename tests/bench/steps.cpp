#include "tests/bench/steps.hpp"

#include <fmt/format.h>
#include <malloc.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "apps/common/stopwatch.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::bench {
namespace {

constexpr int warm_up = 60, timed = 20;

/// Resident memory of this process, without what is free but kept for later [bytes].
double resident() {
  malloc_trim(0);
  std::ifstream statm("/proc/self/statm");
  double all = 0, pages = 0;
  statm >> all >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Parameters sloshing_tank(int particles, int threads) {
  Parameters p;  // 0.6 m x 0.2 m of water
  p.particles.spacing = p.fluid.depth / std::round(std::sqrt(particles / 3.0));
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.05, 1}};
  p.threads = threads;
  return p;
}

Numbers measure(int particles, int threads) {
  const double empty = resident();
  const auto simulation = make_simulation(sloshing_tank(particles, threads), 0);
  const auto take = [&](int steps) {
    for (int k = 0; k < steps; ++k) simulation->step(1e3);
  };
  take(warm_up);
  const Statistics before = simulation->statistics();
  const apps::Stopwatch watch;
  take(timed);
  double rest = watch.seconds();
  const Statistics& after = simulation->statistics();

  const double fluid = static_cast<double>(after.fluid_particles);
  Numbers found{{"fluid", fluid}};
  const auto per_particle = [&](double seconds) { return 1e6 * seconds / (timed * fluid); };
  for (const auto& [stage, seconds] : after.seconds) {
    const auto earlier = before.seconds.find(stage);
    const double taken = seconds - (earlier == before.seconds.end() ? 0 : earlier->second);
    found["stage_" + stage] = per_particle(taken);
    rest -= taken;
  }
  found["stage_rest"] = per_particle(rest);
  found["iterations"] = static_cast<double>(after.iterations - before.iterations) / timed;
  found["bytes"] = (resident() - empty) / fluid;
  return found;
}

}  // namespace

double StepCost::whole() const {
  double sum = 0;
  for (const auto& [stage, time] : microseconds) sum += time;
  return sum;
}

StepCost measure_steps(int particles, int threads) {
  Numbers found = in_child([&] { return measure(particles, threads); });
  StepCost cost{std::lround(found["fluid"]), threads, found["iterations"], found["bytes"], {}};
  const std::string prefix = "stage_";
  for (const auto& [name, value] : found)
    if (name.starts_with(prefix)) cost.microseconds[name.substr(prefix.size())] = value;
  return cost;
}

std::string steps_csv(const std::vector<StepCost>& costs) {
  std::string text = "fluid_particles,threads,iterations_per_step,bytes_per_particle,us_whole";
  for (const auto& [stage, time] : costs.at(0).microseconds) text += ",us_" + stage;
  text += '\n';
  for (const StepCost& cost : costs) {
    text +=
        fmt::format("{},{},{:.2f},{:.0f},{:.4f}", cost.fluid, cost.threads, cost.iterations, cost.bytes, cost.whole());
    for (const auto& [stage, time] : cost.microseconds) text += fmt::format(",{:.4f}", time);
    text += '\n';
  }
  return text;
}

}  // namespace seiche::bench
