#include <gtest/gtest.h>

#include "tests/physics/roll_theory.hpp"
#include "tests/physics/runs.hpp"

namespace seiche::physics {
namespace {

Parameters rolling(double spacing) {
  Parameters p;
  p.particles.spacing = spacing;
  p.motion = {
      .type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::roll, 0.5, 0.8}, .pivot_x = 0.3, .pivot_y = 0.05};
  return p;
}

// The centre of mass moves by 15 mm and is off by 2.8 % of that. Where it moves by less than a spacing the surface is
// too coarse: by 0.5 degrees it moves by 3.7 mm, and is off by 9 % of that here, by 3 % at a spacing of 5 mm.
TEST(Rolling, FollowsPotentialTheory) {
  Parameters p = rolling(0.01);
  p.motion.harmonic.amplitude = 2;
  const RollTheory theory(p);
  const auto simulation = make_simulation(p, 0);
  double error = 0, greatest = 0;
  run(*simulation, 0.05, 1.5, [&](const Frame& frame) {
    const double exact = theory.centre(frame.time);
    error = std::max(error, std::abs(centre(frame) - 0.5 * p.tank.length - exact));
    greatest = std::max(greatest, std::abs(exact));
  });
  EXPECT_LT(error, 0.04 * greatest);
  EXPECT_EQ(simulation->statistics().leaked, 0);
}

/// Root mean square over the fluid of the velocity's difference from theory right after the start, over that of the
/// tank's own velocity there.
double start_error(Parameters p, double pivot_x, double pivot_y) {
  p.motion.pivot_x = pivot_x;
  p.motion.pivot_y = pivot_y;
  const RollTheory theory(p);
  const auto frame = make_simulation(p, 0)->frame(0);
  const double rate = frame->pose.omega[2];
  double sum = 0, whole = 0;
  for (std::size_t i = 0; i < frame->size(); ++i) {
    if (frame->kind[i] != Kind::fluid) continue;
    const auto& r = frame->position[i];
    const auto u = theory.start(r[0], r[1]);
    sum += std::pow(frame->velocity[i][0] - u[0], 2) + std::pow(frame->velocity[i][1] - u[1], 2);
    whole += rate * rate * (std::pow(r[0] - pivot_x, 2) + std::pow(r[1] - pivot_y, 2));
  }
  return std::sqrt(sum / whole);
}

TEST(Rolling, ImpulsiveStartConvergesToPotentialTheory) {
  for (const auto& [x, y] : {std::pair{0.3, 0.05}, {0.1, 0.3}}) {
    const double coarse = start_error(rolling(0.02), x, y), fine = start_error(rolling(0.01), x, y);
    EXPECT_LT(fine, 0.05);
    EXPECT_GT(std::log2(coarse / fine), 0.5);  // As for a surge, the upper corners are singular.
  }
}

// The liquid of the impulsive start has no vorticity in the lab: -2 theta' in the tank. Circulation round the block of
// particles two spacings off walls and surface, over its area.
TEST(Rolling, ImpulsiveStartHasNoVorticityInTheLab) {
  const Parameters p = rolling(0.01);
  const auto frame = make_simulation(p, 0)->frame(0);
  const double l0 = p.particles.spacing;
  const int columns = 60, rows = 20, rim = 2;
  std::vector<Float3> velocity(columns * rows);
  for (std::size_t i = 0; i < frame->size(); ++i) {
    if (frame->kind[i] != Kind::fluid) continue;
    const int column = static_cast<int>(frame->position[i][0] / l0), row = static_cast<int>(frame->position[i][1] / l0);
    velocity[row * columns + column] = frame->velocity[i];
  }
  const auto along = [&](int column, int row, int axis, int other_column, int other_row) {
    return 0.5 * l0 * (velocity[row * columns + column][axis] + velocity[other_row * columns + other_column][axis]);
  };
  const int right = columns - 1 - rim, top = rows - 1 - rim;
  double circulation = 0;
  for (int c = rim; c < right; ++c) circulation += along(c, rim, 0, c + 1, rim) - along(c, top, 0, c + 1, top);
  for (int r = rim; r < top; ++r) circulation += along(right, r, 1, right, r + 1) - along(rim, r, 1, rim, r + 1);
  const double vorticity = circulation / ((right - rim) * (top - rim) * l0 * l0);
  EXPECT_NEAR(vorticity, -2 * frame->pose.omega[2], 0.02 * 2 * frame->pose.omega[2]);
}

// A tank that falls at g/2 and one that rises at g/2, for 40 ms: what the floor carries is rho (g + a) h.
TEST(Heaving, FloorCarriesWhatAccelerationMakesOfGravity) {
  for (const double a : {-4.905, 4.905}) {
    Parameters p = still_tank(0.3, 0.1, 0.2, 0.01);
    p.motion.type = MotionType::file;
    for (int k = 0; k <= 8; ++k) {
      p.motion.series.time.push_back(0.01 * k);
      p.motion.series[DegreeOfFreedom::heave].push_back(0.5 * a * 1e-4 * k * k);
    }
    p.time.end = 0.04;
    const auto simulation = make_simulation(p, 0.01);
    while (simulation->time() < 0.04) simulation->step(0.04);
    const Readings readings = simulation->frame(1)->readings;
    const std::size_t columns = sensor_columns(p).size();
    const double* last = &readings.values[columns * (readings.time.size() - 1)];
    EXPECT_NEAR(last[0], 1000 * (9.81 + a) * 0.1, 0.01 * 1000 * (9.81 + a) * 0.1) << a;
    EXPECT_NEAR(last[columns - 1], 0.5 * a * 0.04 * 0.04, 1e-12) << "heave, exactly";
  }
}

}  // namespace
}  // namespace seiche::physics
