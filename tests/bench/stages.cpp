// The stages of a step, each on its own, in seconds, and seconds a fluid particle.
#include <benchmark/benchmark.h>
#include <omp.h>

#include <map>

#include "solver/operators/close_pairs.hpp"
#include "solver/operators/divergence.hpp"
#include "solver/operators/shift.hpp"
#include "solver/operators/strain_rate.hpp"
#include "tests/bench/stirred_tank.hpp"

namespace seiche::bench {

StirredTank& stirred_tank(int particles) {
  static std::map<int, StirredTank> tanks;
  return tanks.try_emplace(particles, particles).first->second;
}

namespace {

using namespace solver;

template <void (*run)(StirredTank&)>
void stage(benchmark::State& state) {
  StirredTank& tank = stirred_tank(static_cast<int>(state.range(0)));
  omp_set_num_threads(static_cast<int>(state.range(1)));
  for (auto _ : state) run(tank);
  using benchmark::Counter;
  state.counters["s_per_particle"] = Counter(tank.fluid, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

void search(StirredTank& t) { t.list.build(t.s); }

void pairs(StirredTank& t) { t.near_pairs.measure(t.w, t.list, t.s); }

void density_and_surface(StirredTank& t) {
  t.wetness(t.near_pairs, t.ref.n0, solver::Vec<2>::Unit(1), t.s);
  number_density(t.near_pairs, t.s, t.n, t.count);
  mark_free_surface(t.ref, 0.97, count_share, t.n, t.count, t.s.kind, t.s.surface);
  mark_near_surface(t.near_pairs, t.s, t.near);
}

void viscous(StirredTank& t) { strain_rate_divergence(t.near_pairs, t.ref, true, t.s, t.vectors); }

void divergence(StirredTank& t) {
  velocity_divergence(t.near_pairs, t.ref.n0, t.s, t.divergence, t.gradient);
  volume_excess(t.volume, t.whole, t.list, t.s, t.excess);
}

void assembly(StirredTank& t) { t.assemble(); }

void gradient(StirredTank& t) {
  pressure_gradient(CorrectedGradient{}, t.near_pairs, t.ref.n0, &t.slopes, t.s, t.vectors);
}

void shift(StirredTank& t) { particle_shift(t.near_pairs, t.ref.n0, 0.1, l0, t.near, t.s, t.vectors); }

void separation(StirredTank& t) {
  collide_close_pairs(0.8 * l0, l0, t.near, t.list, t.s, t.collisions);
  const auto nearest = [&](const Vec<2>& r) { return t.tank->nearest(r); };
  collide_with_walls(0.8 * l0, l0, t.near, t.collisions.at_wall, nearest, t.list, t.s);
}

void sizes(benchmark::internal::Benchmark* of) {
  of->ArgNames({"particles", "threads"})->ArgsProduct({{12000, 200000}, {1, 2}});
  of->UseRealTime()->Unit(benchmark::kMillisecond);
}

BENCHMARK(stage<search>)->Name("search")->Apply(sizes);
BENCHMARK(stage<pairs>)->Name("pairs")->Apply(sizes);
BENCHMARK(stage<density_and_surface>)->Name("density_and_surface")->Apply(sizes);
BENCHMARK(stage<viscous>)->Name("viscous")->Apply(sizes);
BENCHMARK(stage<divergence>)->Name("divergence")->Apply(sizes);
BENCHMARK(stage<assembly>)->Name("assembly")->Apply(sizes);
BENCHMARK(stage<gradient>)->Name("gradient")->Apply(sizes);
BENCHMARK(stage<shift>)->Name("shift")->Apply(sizes);
BENCHMARK(stage<separation>)->Name("separation")->Apply(sizes);

}  // namespace
}  // namespace seiche::bench
