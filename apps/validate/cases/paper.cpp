#include <fmt/format.h>

#include "apps/validate/cases/cases.hpp"

namespace seiche::apps::validate {
namespace {

std::optional<Target> target(const std::string& kernel, double end) {
  if (kernel == "KF2" || kernel == "KF5") return at_most(2);
  if (kernel == "KF3") return at_least(end);
  return {};
}

}  // namespace

Findings paper(Bench& bench) {
  Findings found;
  std::vector<double> spacings{0.01};
  if (!bench.quick()) spacings.push_back(0.005);
  std::vector<std::string> kernels{"KF2", "KF5", "KF3"};
  for (const double spacing : spacings)
    for (const std::string& kernel : kernels) {
      const Recording run =
          bench.attempt("pan2008-paper", {"method.kernel=" + kernel, fmt::format("particles.spacing={}", spacing)});
      found.figures.push_back({fmt::format("{:g} mm, {}: lasts", 1000 * spacing, kernel), run.end, "s",
                               target(kernel, run.parameters.time.end)});
      if (kernel != "KF3" || !found.charts.empty()) continue;
      const Series p = run.sensors.at("p_left_bottom").between(0, 3);
      found.charts.push_back({"The paper's own scheme, 10 mm, KF3: left bottom corner",
                              "t [s]",
                              "pressure [Pa]",
                              {{"run", p.t, p.y}, {"at rest", {0, 3}, {1962, 1962}, render::Mark::dashes}}});
    }
  return found;
}

}  // namespace seiche::apps::validate
