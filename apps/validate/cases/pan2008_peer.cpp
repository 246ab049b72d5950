#include "apps/common/filter.hpp"
#include "apps/validate/cases/pan2008_runs.hpp"
#include "apps/validate/measures.hpp"

namespace seiche::apps::validate::pan {

void add_peer_figures(std::vector<Figure>& figures, const Bench& bench, const References& theory, double weight) {
  constexpr const char* peer = "vof_2p5mm_slip_impulsive";
  const std::string title = "interFoam, 2.5 mm: ";
  const auto level = [&](double from, double to) {
    return compare(bench.reference("theory_fnpf_impulsive", "t", "eta_left_x20mm"),
                   bench.reference(peer, "t", "eta_left_x20mm"), {from, to});
  };
  const Series pressure = low_pass(bench.reference(peer, "t", "p_left_bottom"), 0.5, 4, cut);
  figures.push_back(
      {title + "elevation 20 mm off the left wall, relative L2, 0-3 s", level(0, 3).relative_l2(), "", {}});
  figures.push_back({title + "the same, RMS over max, 0.5-4 s", 100 * level(0.5, 4).of_most(), "%", {}});
  figures.push_back({title + "corner pressure below 10 Hz less its mean error, RMS over max, 0.5-4 s",
                     100 * compare(theory.pressure, pressure, {0.5, 4, weight}).unbiased_of_most(),
                     "%",
                     {}});
}

}  // namespace seiche::apps::validate::pan
