#include <fmt/format.h>

#include <cmath>

#include "apps/common/filter.hpp"
#include "apps/validate/cases/pan2008_runs.hpp"
#include "apps/validate/fit.hpp"
#include "apps/validate/measures.hpp"
#include "apps/validate/surface.hpp"

// The tank of Pan, Zhang and Lu (2008) against fully nonlinear potential theory. Where theory and two-fluid codes
// differ among themselves by 2.6 and 4 % in elevation and by 1.2 and 3.4 % in pressure (0.5-4 s, 4-7 s), nothing better
// than that can be asked of a run.
namespace seiche::apps::validate {
namespace {

using namespace pan;

/// One spacing's run, and what is asked of it; nothing where the run is too short for it.
struct Resolution {
  double spacing, end;  // [m], [s]
  std::optional<Target> early_noise = {}, late_noise = {}, mean_pressure = {}, early_pressure = {}, late_pressure = {};
  std::optional<Target> early_level = {}, first_level = {}, later_level = {};
};

const std::vector<Resolution> resolutions{
    {.spacing = 0.01, .end = 7, .early_noise = at_most(0.2), .early_level = at_most(0.06)},
    {.spacing = 0.005,
     .end = 10,
     .early_noise = at_most(0.1),
     .late_noise = at_most(0.4),
     .mean_pressure = within(0.5),
     .early_pressure = at_most(2),
     .late_pressure = at_most(6),
     .early_level = at_most(0.04),
     .first_level = at_most(3),
     .later_level = at_most(5)},
    {.spacing = 0.0025, .end = 3.05, .early_level = at_most(0.025)},
};

/// RMS distance of the profiles at 1, 2 and 3 s from theory's, 10 mm off the walls and further [m].
double profile_error(const Run& run, const References& theory) {
  ProfileDistance sum;
  for (const double t : {1.0, 2.0, 3.0}) {
    const ProfileDistance d = profile_distance(theory.profiles.at(t), profile(run.recording, t), 0.01, 0.59);
    sum.squares += d.squares;
    sum.count += d.count;
  }
  return std::sqrt(sum.squares / static_cast<double>(sum.count));
}

/// The worse of the two walls.
template <class Measure>
double worse_wall(const Run& run, const References& theory, double from, double to, Measure measure) {
  const Window window{from, to};
  return std::max(measure(compare(theory.left, run.left(), window)),
                  measure(compare(theory.right, run.right(), window)));
}

void add_pressure_figures(std::vector<Figure>& figures, const std::string& title, const Resolution& of, const Run& run,
                          const References& theory) {
  const double weight = run.weight();
  const Series& pressure = run.pressure();
  const auto below_cut = [&](double from, double to) {
    const Window window{from, to, weight};
    return 100 * compare(theory.pressure, low_pass(pressure, from, to, cut), window).unbiased_of_most();
  };
  const auto add = [&](const char* name, double value, const std::optional<Target>& target) {
    figures.push_back({title + name, value, "%", target});
  };
  add("corner pressure above 10 Hz, RMS over rho g h, 0.5-3 s", 100 * noise(pressure, 0.5, 3, cut) / weight,
      of.early_noise);
  if (of.end < 7) return;
  add("the same, 3-7 s", 100 * noise(pressure, 3, 7, cut) / weight, of.late_noise);
  add("corner pressure, mean error over rho g h, 0.5-7 s",
      100 * compare(theory.pressure, pressure, {0.5, 7, weight}).bias / weight, of.mean_pressure);
  add("corner pressure below 10 Hz less its mean error, RMS over max, 0.5-4 s", below_cut(0.5, 4), of.early_pressure);
  add("the same, 4-7 s", below_cut(4, 7), of.late_pressure);
}

void add_level_figures(std::vector<Figure>& figures, const std::string& title, const Resolution& of, const Run& run,
                       const References& theory) {
  const auto of_most = [](const Difference& d) { return 100 * d.of_most(); };
  figures.push_back({title + "worse wall's elevation, relative L2, 0-3 s",
                     worse_wall(run, theory, 0, 3, [](const Difference& d) { return d.relative_l2(); }), "",
                     of.early_level});
  if (of.end < 7) return;
  figures.push_back({title + "worse wall's elevation, RMS over max, 0.5-4 s", worse_wall(run, theory, 0.5, 4, of_most),
                     "%", of.first_level});
  figures.push_back({title + "the same, 4-7 s", worse_wall(run, theory, 4, 7, of_most), "%", of.later_level});
  if (of.end < 10) return;
  const double depth = run.recording.parameters.fluid.depth;
  figures.push_back({title + "mean surface height, 6-7 s less 0-1 s, of the depth",
                     100 * (mean_height(run.recording, 6, 7) - mean_height(run.recording, 0, 1)) / depth, "%",
                     within(0.3)});
  figures.push_back(
      {title + "particles lost in 10 s", static_cast<double>(run.recording.statistics.leaked), "", at_most(0)});
}

}  // namespace

Findings pan2008(Bench& bench) {
  const References theory = read_references(bench);
  Findings findings;
  std::vector<Run> runs;
  std::vector<double> spacings, errors;
  for (const Resolution& of : resolutions) {
    if (bench.quick() && !runs.empty()) break;
    runs.push_back(make_run(bench, of.spacing, of.end));
    const std::string title = millimetres(of.spacing) + ": ";
    add_pressure_figures(findings.figures, title, of, runs.back(), theory);
    add_level_figures(findings.figures, title, of, runs.back(), theory);
    spacings.push_back(of.spacing);
    errors.push_back(profile_error(runs.back(), theory));
    findings.figures.push_back({title + "profiles at 1, 2, 3 s, RMS distance", 1000 * errors.back(), "mm", {}});
    findings.figures.push_back({fmt::format("{}surface flags that change in {:g} s, 0.5-3 s", title, frame_interval),
                                100 * runs.back().flags.changing(0.5, 3),
                                "%",
                                {}});
  }
  if (runs.size() == resolutions.size())
    findings.figures.push_back({"order of the profiles' distance in l0", order(spacings, errors), "", at_least(1)});
  add_peer_figures(findings.figures, bench, theory, runs[0].weight());
  findings.charts = charts(runs, theory);
  return findings;
}

}  // namespace seiche::apps::validate
