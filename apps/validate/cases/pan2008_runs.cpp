#include "apps/validate/cases/pan2008_runs.hpp"

#include <fmt/format.h>

#include "apps/validate/surface.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate::pan {

References read_references(const Bench& bench) {
  constexpr const char* file = "theory_fnpf_impulsive";
  References r{bench.reference(file, "t", "eta_left"),
               bench.reference(file, "t", "eta_right"),
               bench.reference(file, "t", "p_left_bottom"),
               {}};
  const std::string profiles = std::string(file) + "_profiles";
  const Series x = bench.reference(profiles, "t", "x"), z = bench.reference(profiles, "t", "z");
  for (std::size_t i = 0; i < x.size(); ++i) {
    r.profiles[x.t[i]].t.push_back(x.y[i]);
    r.profiles[x.t[i]].y.push_back(z.y[i]);
  }
  return r;
}

double Run::weight() const {
  const Parameters& p = recording.parameters;
  return p.fluid.density * p.gravity.size() * p.fluid.depth;
}

Run make_run(Bench& bench, double spacing, double end) {
  const std::vector<std::string> settings{fmt::format("particles.spacing={}", spacing), fmt::format("time.end={}", end),
                                          fmt::format("output.frame_rate={}", 1 / frame_interval)};
  const double length = tank_surface(bench.scene("pan2008", settings).parameters).size()[0];
  Run run;
  const auto look = [&run](const Frame& frame, const RunInfo&) { run.flags.see(frame); };
  run.recording = bench.run("pan2008", settings, look, stations(length, 60));
  return run;
}

std::string millimetres(double spacing) { return fmt::format("{:g} mm", 1000 * spacing); }

}  // namespace seiche::apps::validate::pan
