#include "solver/preset.hpp"

namespace seiche {

void apply_preset(Parameters& p, Preset preset) {
  if (preset == Preset::stabilised) {
    p.method = {};
    p.pressure.solver = Parameters::Pressure{}.solver;
    p.time.courant = Parameters::Time{}.courant;
  } else {
    // The paper names no radius, no parting distance and no cap: r_e = 2.1 l0 and 3.1 l0 (Laplacian) are the usual ones
    // of the method (Koshizuka & Oka 1996), half a spacing is what parts a pair without disturbing its neighbours.
    auto& m = p.method;
    m.kernel = "KF3";
    m.kf2_alpha = 3.0;
    m.radius_density = m.radius_gradient = 2.1;
    m.radius_laplacian = 3.1;
    m.surface_beta = 0.97;
    m.order = Order::move_first;
    m.wall_model = WallModel::particles;
    m.source = SourceTerm::density;
    m.gradient = GradientModel::minimum;
    m.surface = SurfaceTest::density;
    m.separation = SeparationModel::part;
    m.separation_distance = 0.5;
    m.shift = 0;
    m.viscous = ViscousModel::laplacian;
    m.wall = WallSlip::none;
    p.pressure.solver = SolverName::iccg;
    p.time.courant = 0.1;
  }
  p.preset = preset;
}

}  // namespace seiche
