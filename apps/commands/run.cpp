#include "apps/commands/run.hpp"

#include <fmt/format.h>
#include <omp.h>

#include "apps/common/exit_codes.hpp"
#include "apps/common/signals.hpp"
#include "apps/common/stopwatch.hpp"
#include "apps/report/command.hpp"
#include "apps/report/report.hpp"
#include "apps/run/loop.hpp"
#include "apps/run/run_info.hpp"
#include "apps/run/run_json.hpp"
#include "apps/run/stored_run.hpp"
#include "apps/run/summary.hpp"
#include "apps/scene/scene_file.hpp"
#include "apps/scene/scene_text.hpp"
#include "solver/make_simulation.hpp"
#include "solver/motion/warnings.hpp"

namespace seiche::apps {
namespace {

int exit_code(Ending::Status status) {
  switch (status) {
    case Ending::Status::finished:
      return done;
    case Ending::Status::interrupted:
      return interrupted;
    case Ending::Status::failed:
      break;
  }
  return failed;
}

/// What a record asks of the liquid, and what can't be meant.
void tell_motion(const Parameters& p, bool quiet) {
  for (const std::string& warning : warnings(p)) fmt::print(stderr, "warning: {}\n", warning);
  if (quiet || p.motion.type != MotionType::file) return;
  const auto [acceleration, time] = greatest_acceleration(p);
  fmt::print("{}: the tank's acceleration is {:.3g} m/s^2 at most, at {:.3g} s\n", p.motion.file, acceleration, time);
}

// The run proper: simulation and folder are ready.
int simulate(const Scene& scene, const OutputFolder& folder, Simulation& simulation, const RunRequest& request) {
  const Stopwatch watch;
  const SignalWatch signals;
  Progress progress(Progress::suitable(request.quiet));
  Outputs outputs = make_outputs(scene, folder);
  write_samples(folder.samples(), scene);
  write_run_json(folder.record(), scene, {{}, simulation.statistics(), {}});

  const Ending ending = run_loop(simulation, outputs, run_info(scene), progress, [&] { return signals.caught(); });

  const Statistics& totals = simulation.statistics();
  const RunRecord record{ending, totals, {totals.seconds, outputs.seconds(), ending.waited, watch.seconds()}};
  write_run_json(folder.record(), scene, record);
  if (scene.writes(OutputKind::report))
    write_report(folder.report(),
                 report_of(read_run(folder.path), report::command_text({"run", request.scene}, request.overrides)));
  print_summary(scene, folder, record, request.quiet);
  return exit_code(ending.status);
}

}  // namespace

int run(const RunRequest& request) {
  Scene scene = read_scene(request.scene, request.overrides);
  if (request.dry_run) {
    fmt::print("{}", explained_scene_text(scene));
    return done;
  }
  scene.parameters.threads = request.threads > 0 ? request.threads : omp_get_num_procs();

  const OutputFolder folder{request.folder.empty() ? "out" / std::filesystem::path(scene.name) : request.folder,
                            scene.name};
  folder.check(request.overwrite);
  check_outputs(scene, folder);
  const auto simulation = make_simulation(scene.parameters, scene.samples() ? 1 / scene.output.probe_rate : 0);
  tell_motion(scene.parameters, request.quiet);
  folder.prepare();
  return simulate(scene, folder, *simulation, request);
}

}  // namespace seiche::apps
