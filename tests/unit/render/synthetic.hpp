#pragma once
#include <algorithm>
#include <cmath>

#include "solver/frame.hpp"
#include "solver/make_simulation.hpp"
#include "solver/run_info.hpp"

namespace seiche::test {

/// A tank as the solver would describe it, its liquid still with depth H.
struct Box {
  double length = 0.6, height = 0.4, width = 0, depth = 0.2, spacing = 0.005;
  bool closed = true;
};

inline SurfaceMesh surface_of(const Box& box) {
  Parameters p;
  p.tank = {.length = box.length, .height = box.height, .width = box.width, .closed = box.closed};
  return tank_surface(p);
}

inline RunInfo run_info(const Box& box) {
  RunInfo run;
  run.name = "pan2008";
  run.version = "0.1.0";
  run.scene_hash = "0123456789abcdef";
  run.parameters = "preset = \"stabilised\"\n";
  run.kernel = "KF3";
  run.preset = "stabilised";
  run.dimension = box.width > 0 ? 3 : 2;
  run.tank = surface_of(box);
  run.closed = box.closed;
  run.depth = box.depth;
  run.density = 1000;
  run.gravity = run.pull = 9.81;
  run.spacing = box.spacing;
  run.excursion = {0.02, 0, 0};
  run.frame_interval = 0.02;
  run.end = 10;
  return run;
}

/// A lattice of fluid up to a sloping surface, with hydrostatic pressure below it, inside of one layer of wall
/// particles and two of dummies. `slope`: rise of the surface along the tank [-].
inline FramePtr lattice(const Box& box, double slope, long index = 0) {
  auto frame = std::make_shared<Frame>();
  const double l0 = box.spacing;
  const bool is_3d = box.width > 0;
  const auto cells = [&](double size) { return static_cast<int>(std::lround(size / l0)); };
  const int nx = cells(box.length), ny = cells(box.height), nz = is_3d ? cells(box.width) : 1;
  const int layers = 3, zlayers = is_3d ? layers : 0;
  for (int k = -zlayers; k < nz + zlayers; ++k)
    for (int j = -layers; j < ny + (box.closed ? layers : 0); ++j)
      for (int i = -layers; i < nx + layers; ++i) {
        const auto outside = [](int at, int count) { return at < 0 ? -at : at >= count ? at - count + 1 : 0; };
        const int out = std::max({outside(i, nx), outside(j, ny), is_3d ? outside(k, nz) : 0});
        const double x = (i + 0.5) * l0, y = (j + 0.5) * l0, z = is_3d ? (k + 0.5) * l0 : 0;
        const double top = box.depth + slope * (x - box.length / 2);
        if (out == 0 && y > top) continue;
        frame->position.push_back({static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)});
        frame->velocity.push_back({static_cast<float>(slope * y), static_cast<float>(-slope * x), 0});
        frame->pressure.push_back(static_cast<float>(1000 * 9.81 * std::max(top - y, 0.0)));
        frame->number_density.push_back(1);
        frame->kind.push_back(out == 0 ? Kind::fluid : out == 1 ? Kind::wall : Kind::dummy);
        frame->free_surface.push_back(out == 0 && y + l0 > top);
        frame->id.push_back(static_cast<std::uint32_t>(frame->id.size()));
      }
  frame->index = index;
  frame->step = 10 * index;
  frame->time = 0.02 * static_cast<double>(index);
  frame->pose.pivot = {box.length / 2, 0.1, 0};
  frame->pose.displacement = {0.02 * std::sin(6.28 * frame->time), 0, 0};
  return frame;
}

}  // namespace seiche::test
