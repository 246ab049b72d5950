#include "tests/bench/programs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "apps/common/stopwatch.hpp"
#include "tests/cli/program.hpp"

namespace seiche::bench {

ProgramCost time_program(const std::string& scene, double tolerance, int repetitions,
                         const std::filesystem::path& folder) {
  ProgramCost cost{scene, tolerance};
  const std::filesystem::path out = std::filesystem::absolute(folder / scene);
  for (int k = 0; k < repetitions; ++k) {
    const apps::Stopwatch watch;
    const test::Result result =
        test::seiche(".", {"run", SEICHE_SCENES "/bench/" + scene + ".toml", "--quiet", "--overwrite", "-o", out,
                           "--set", fmt::format("pressure.tolerance={:g}", tolerance)});
    const double seconds = watch.seconds();
    if (result.code != 0) throw std::runtime_error(fmt::format("{} at {:g}: {}", scene, tolerance, result.err));
    const auto record = nlohmann::json::parse(std::ifstream(out / "run.json"));
    cost.steps = record["steps"]["count"];
    cost.iterations = record["pressure"]["iterations_per_step"];
    cost.per_step.push_back(seconds / static_cast<double>(cost.steps));
  }
  std::sort(cost.per_step.begin(), cost.per_step.end());
  return cost;
}

std::string programs_csv(const std::vector<ProgramCost>& costs) {
  std::string text = "scene,tolerance,steps,iterations_per_step,repetitions,min_ms_per_step,median_ms_per_step\n";
  for (const ProgramCost& cost : costs) {
    const std::size_t half = cost.per_step.size() / 2;
    const double median =
        cost.per_step.size() % 2 ? cost.per_step[half] : 0.5 * (cost.per_step[half - 1] + cost.per_step[half]);
    text += fmt::format("{},{:g},{},{:.2f},{},{:.4g},{:.4g}\n", cost.scene, cost.tolerance, cost.steps, cost.iterations,
                        cost.per_step.size(), 1e3 * cost.per_step[0], 1e3 * median);
  }
  return text;
}

}  // namespace seiche::bench
