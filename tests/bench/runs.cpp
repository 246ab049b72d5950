// Times whole steps, whole programs and the memory, into CSV files and a plot.
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>

#include "render/files/file.hpp"
#include "tests/bench/bandwidth.hpp"
#include "tests/bench/plot.hpp"
#include "tests/bench/programs.hpp"
#include "tests/bench/steps.hpp"

namespace {

using namespace seiche::bench;
namespace fs = std::filesystem;

// To the file and to standard output.
void write(const fs::path& file, const std::string& csv) {
  seiche::render::write_file(file, csv);
  fmt::print("{}\n{}\n", file.string(), csv);
  std::fflush(stdout);
}

void run(const fs::path& folder, bool quick) {
  fs::create_directories(folder);
  const auto sizes = quick ? std::vector<int>{3000, 12000} : std::vector<int>{3000, 12000, 50000, 200000, 400000};
  std::vector<StepCost> steps;
  for (int size : sizes)
    for (int threads : {1, 2}) {
      steps.push_back(measure_steps(size, threads));
      fmt::print("{} particles, {} threads: {:.2f} microseconds a particle and step\n", steps.back().fluid, threads,
                 steps.back().whole());
      std::fflush(stdout);
    }
  write(folder / "steps.csv", steps_csv(steps));

  write(folder / "bandwidth.csv", bandwidth_csv(measure_bandwidth()));

  std::vector<ProgramCost> programs;
  for (const char* scene : {"dam-10mm", "dam-5mm"})
    for (double tolerance : {1e-5, 1e-14})
      if (!quick || tolerance > 1e-14) programs.push_back(time_program(scene, tolerance, quick ? 1 : 5, folder));
  write(folder / "programs.csv", programs_csv(programs));
  // Last: all other processes are forked from one that has no threads.
  plot(folder / "bench.png", steps);
}

}  // namespace

int main(int count, char** words) {
  const bool quick = count == 3 && std::string(words[2]) == "quick";
  if (count != 2 && !quick) {
    fmt::print(stderr, "usage: bench_runs FOLDER [quick]\n");
    return 2;
  }
  try {
    run(words[1], quick);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_runs: {}\n", error.what());
    return 1;
  }
  return 0;
}
