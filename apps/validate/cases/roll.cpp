#include <fmt/format.h>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/measures.hpp"
#include "apps/validate/modal_theory.hpp"

namespace seiche::apps::validate {

// The waves of even modes that a roll raises are of second order; half the difference of the walls' elevations is free
// of them, and of half the scatter of a surface made of particles.
Findings roll(Bench& bench) {
  std::vector<std::string> settings{"output.frame_rate=20"};
  if (bench.quick()) settings.emplace_back("particles.spacing=0.01");
  const Recording run = bench.run("roll", settings);
  Series half = run.sensors.at("eta_left");
  const Series& right = run.sensors.at("eta_right");
  for (std::size_t i = 0; i < half.size(); ++i) half.y[i] = 0.5 * (half.y[i] - right.y[i]);
  const Series theory = roll_elevation(run.parameters, 0.01, run.end);

  const double spacing = 1000 * run.parameters.particles.spacing;
  Chart chart{fmt::format("Roll of {:g} degrees, {:g} mm", run.parameters.motion.harmonic.amplitude, spacing),
              "t [s]",
              "(left - right)/2 [mm]",
              {{"run", half.t, half.y}, {"linear theory", theory.t, theory.y, render::Mark::dashes}}};
  for (render::Curve& curve : chart.curves)
    for (double& y : curve.y) y *= 1000;
  return {{{fmt::format("{:g} mm: half the walls' difference, RMS over max, 0-{:g} s", spacing, run.end),
            100 * compare(theory, half, {0, run.end}).of_most(), "%",
            bench.quick() ? std::optional<Target>() : at_most(5)}},
          {chart}};
}

}  // namespace seiche::apps::validate
