// Each pressure solver on the system of a stirred tank, from p = 0 to a relative residual of 1e-5.
#include <benchmark/benchmark.h>
#include <omp.h>

#include "solver/pressure/pressure_solver.hpp"
#include "tests/bench/stirred_tank.hpp"

namespace seiche::bench {
namespace {

void solve(benchmark::State& state, SolverName name) {
  StirredTank& tank = stirred_tank(static_cast<int>(state.range(0)));
  omp_set_num_threads(static_cast<int>(state.range(1)));
  Eigen::VectorXd b = tank.pressure.rhs();  // a still tank's, and a source that isn't smooth
  for (int k = 0; k < b.size(); ++k) b[k] += 10 * std::sin(k);
  const auto solver = solver::make_pressure_solver(name, 1e-5, 100000);
  solver::SolveReport report;
  for (auto _ : state) {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
    report = solver->solve(tank.pressure.matrix(), b, x);
  }
  if (!report.converged) state.SkipWithError("did not converge");
  state.SetLabel(std::to_string(report.iterations) + " iterations");
  using benchmark::Counter;
  state.counters["s_per_particle"] = Counter(tank.fluid, Counter::kIsIterationInvariantRate | Counter::kInvert);
}

// Those whose work grows faster than the tank only get the small one.
const bool registered = [] {
  for (const auto& [choice, name, help] : ChoiceTable<SolverName>::rows) {
    const bool grows = choice == SolverName::sor || choice == SolverName::cholmod;
    benchmark::RegisterBenchmark(("solve_" + std::string(name)).c_str(), solve, choice)
        ->ArgNames({"particles", "threads"})
        ->ArgsProduct({grows ? std::vector<std::int64_t>{12000} : std::vector<std::int64_t>{12000, 200000}, {1, 2}})
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace seiche::bench
