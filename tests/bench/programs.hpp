#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seiche::bench {

/// The time of a scene as a whole program, from its start to its end, with as many threads as cores.
struct ProgramCost {
  std::string scene;
  double tolerance = 0;  ///< of the pressure solver
  long steps = 0;
  double iterations = 0;           ///< of the pressure solver a step
  std::vector<double> per_step{};  ///< wall-clock time over the steps, a repetition each, ascending [s]
};

/// Runs scenes/bench/SCENE.toml into `folder`/SCENE. Throws std::runtime_error where a run fails.
ProgramCost time_program(const std::string& scene, double tolerance, int repetitions,
                         const std::filesystem::path& folder);

/// With the least and the median of the repetitions, in milliseconds.
std::string programs_csv(const std::vector<ProgramCost>& costs);

}  // namespace seiche::bench
