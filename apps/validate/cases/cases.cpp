#include "apps/validate/cases/cases.hpp"

namespace seiche::apps::validate {

std::vector<Case> all_cases() {
  return {
      {"still-tank", "still water stays still under its hydrostatic pressure, in tanks of 0.5 and 20 m", still_tank},
      {"pan2008", "surge near resonance: pressure, wall elevations and profiles against nonlinear potential theory",
       pan2008},
      {"standing-wave", "period and decay of a free wave against the dispersion relation and 2 nu k^2", standing_wave},
      {"dam-break", "front of a collapsing column against the experiment of Martin and Moyce", dam_break},
      {"roll", "a rolling tank's elevation against linear potential theory", roll},
      {"tanks", "tanks of other shapes and baffles: still water, and the first period against finite elements", tanks},
      {"tanks-3d", "the same in 3-D: a sphere, cylinders, a membrane tank, an STL file", tanks_3d},
      {"tanks-moved", "such tanks that roll, surge and shake: speed in the lab, force against theory, leaks",
       tanks_moved},
      {"motions", "an orbit, steady yaw and a diagonal push in 3-D against theory", motions},
      {"spheric10", "a lateral impact against SPHERIC's benchmark 10: when it comes, and the pressure before",
       spheric10},
      {"paper", "which kernels of the paper's own scheme last", paper},
  };
}

}  // namespace seiche::apps::validate
