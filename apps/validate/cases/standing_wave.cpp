#include "solver/modes/standing_wave.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "apps/validate/cases/cases.hpp"
#include "apps/validate/fit.hpp"
#include "apps/validate/modal_theory.hpp"
#include "solver/make_simulation.hpp"

namespace seiche::apps::validate {
namespace {

// What the wave's flow has of the mode at each frame, q = sum u . U / sum U . U over the fluid, U the start's velocity
// at the particles' places: 1 at the start, then cos(omega t) exp(-gamma t). All particles share in it, so that it is
// far smoother than any gauge.
Recording follow(Bench& bench, double viscosity, std::vector<std::string> settings, Series& q) {
  settings.insert(settings.end(), {fmt::format("fluid.viscosity={:g}", viscosity), "output.frame_rate=100"});
  const Parameters p = bench.scene("standing-wave", settings).parameters;
  const solver::modes::StandingWave wave(p, tank_surface(p).size()[0]);
  return bench.run("standing-wave", settings, [&](const Frame& frame, const RunInfo&) {
    double along = 0, whole = 0;
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (frame.kind[i] != Kind::fluid) continue;
      const auto mode = wave.velocity<2>({frame.position[i][0], frame.position[i][1]});
      along += frame.velocity[i][0] * mode[0] + frame.velocity[i][1] * mode[1];
      whole += mode.squaredNorm();
    }
    q.t.push_back(frame.time);
    q.y.push_back(along / whole);
  });
}

}  // namespace

Findings standing_wave(Bench& bench) {
  const std::vector<std::string> settings =
      bench.quick() ? std::vector<std::string>{"particles.spacing=0.01"} : std::vector<std::string>{};
  const std::string title = bench.quick() ? "h/20: " : "h/40: ";
  const auto asked = [&](Target target) { return bench.quick() ? std::optional<Target>() : target; };

  Series free;
  const Parameters p = follow(bench, 0, settings, free).parameters;
  const int n = p.fluid.wave_mode;
  const double k = n * std::numbers::pi / tank_surface(p).size()[0], omega = natural_frequency(p, n);
  const Oscillation own = fit_oscillation(free, omega);
  Findings found;
  found.figures = {
      {title + "period less that of the dispersion relation", 100 * (omega / own.omega - 1), "%", asked(within(0.5))},
      {title + "decay at nu = 0, as a viscosity nu_num", 1e6 * own.decay / (2 * k * k), "mm^2/s", {}}};
  Chart chart{fmt::format("Standing wave, l0 = {}: share of the mode", title.substr(0, 4)),
              "t [s]",
              "share of the velocity at the start [-]",
              {{"nu = 0", free.t, free.y}}};
  const std::vector<double> viscosities = bench.quick() ? std::vector<double>{} : std::vector{0.001, 0.002};
  for (const double viscosity : viscosities) {
    Series q;
    follow(bench, viscosity, settings, q);
    const double decay = fit_oscillation(q, omega).decay - own.decay;
    found.figures.push_back({fmt::format("{}decay at nu = {:g} m^2/s less that at 0, over 2 nu k^2", title, viscosity),
                             decay / (2 * viscosity * k * k), "", asked({0.9, 1.1})});
    chart.curves.push_back({fmt::format("nu = {:g} m^2/s", viscosity), q.t, q.y});
  }
  Series theory;
  for (const double t : free.t) {
    theory.t.push_back(t);
    theory.y.push_back(std::cos(omega * t));
  }
  chart.curves.push_back({"linear theory, nu = 0", theory.t, theory.y, render::Mark::dashes});
  found.charts = {chart};
  return found;
}

}  // namespace seiche::apps::validate
