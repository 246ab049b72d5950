#include <gtest/gtest.h>

#include <cmath>

#include "solver/preset.hpp"
#include "tests/unit/solver/expect_refused.hpp"

namespace seiche {
namespace {

/// Expects the spoilt defaults to be refused with a message that has every one of the words.
void expect_refused(void (*spoil)(Parameters&), const std::vector<std::string>& words) {
  Parameters p;
  spoil(p);
  test::expect_refused(p, words);
}

TEST(CheckParameters, AcceptsTheDefaultsInBothDimensions) {
  Parameters p;
  EXPECT_NO_THROW(check_parameters(p));
  p.tank.width = 0.1;
  p.fluid.column = 0.15;
  p.fluid.depth = p.tank.height;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, WantsWholeNumbersOfSpacings) {
  expect_refused([](Parameters& p) { p.tank.closed = false, p.tank.length = 0.603; },
                 {"tank.length = 0.603 m", "120.6", "0.6", "0.605"});
  expect_refused([](Parameters& p) { p.tank.closed = false, p.tank.height = 0.4012; },
                 {"tank.height = 0.4012 m", "0.4 or 0.405"});
  expect_refused([](Parameters& p) { p.tank.closed = false, p.tank.width = 0.1024; }, {"tank.width = 0.1024 m"});
  expect_refused([](Parameters& p) { p.fluid.column = 0.1, p.fluid.depth = 0.2001; }, {"fluid.depth = 0.2001 m"});
  expect_refused([](Parameters& p) { p.fluid.column = 0.0524; }, {"fluid.column = 0.0524 m"});
}

TEST(CheckParameters, TakesAnySpacingInAClosedTank) {
  Parameters p;
  p.tank = {.length = 0.603, .height = 0.4012, .width = 0.1024};
  p.fluid.depth = 0.2001;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, WantsASpacingOfGasBelowARoof) {
  expect_refused([](Parameters& p) { p.fluid.depth = 0.398; }, {"fluid.depth = 0.398 m", "0.395 m", "98.75 %"});
  Parameters p;
  p.fluid.depth = 0.395;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, ForgivesTheRoundingOfDecimals) {
  Parameters p;
  p.particles.spacing = 0.1 + 0.2;  // not 0.3
  p.tank = {.length = 3, .height = 2.4, .width = 1.2, .closed = true};
  p.fluid.depth = 1.2;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, WantsFourSpacingsAtLeast) {
  expect_refused([](Parameters& p) { p.fluid.depth = 0.015; }, {"fluid.depth", "3 spacings", "4 at least"});
  Parameters p;
  p.fluid.depth = 0.02;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, WantsTheWaterInsideTheTank) {
  expect_refused([](Parameters& p) { p.fluid.depth = 0.405; }, {"fluid.depth = 0.405 m", "0.4 m"});
  expect_refused([](Parameters& p) { p.fluid.column = 0.605; }, {"fluid.column = 0.605 m", "tank.length = 0.6 m"});
}

TEST(CheckParameters, WantsAWaveToHaveTheWholeTankAndToBeLongEnough) {
  expect_refused([](Parameters& p) { p.fluid.wave_amplitude = 0.01, p.fluid.column = 0.3; },
                 {"fluid.wave_amplitude", "fluid.column"});
  expect_refused([](Parameters& p) { p.fluid.wave_amplitude = 0.01, p.fluid.wave_mode = 31; },
                 {"fluid.wave_mode = 31", "3.87 spacings"});
  Parameters p;
  p.fluid.wave_amplitude = 0.01;
  p.fluid.wave_mode = 30;
  EXPECT_NO_THROW(check_parameters(p));
}

TEST(CheckParameters, WantsAShiftOnlyWhereItIsApplied) {
  expect_refused([](Parameters& p) { p.method.order = Order::move_first; }, {"method.shift", "project-first"});
}

TEST(CheckParameters, WantsWhatTheMotionNeedsAndNothingThatItIgnores) {
  expect_refused([](Parameters& p) { p.motion.type = MotionType::harmonics; },
                 {"motion.type = harmonics", "[[motion.harmonic]]"});
  expect_refused(
      [](Parameters& p) {
        p.motion.type = MotionType::harmonic;
        p.motion.harmonic.of = DegreeOfFreedom::surge;
        p.motion.harmonics.resize(1);
      },
      {"motion.type = surge ignores [[motion.harmonic]]"});
  expect_refused(
      [](Parameters& p) {
        p.motion.type = MotionType::harmonics;
        p.motion.harmonics = {{DegreeOfFreedom::sway, 1, 1, 0}};
      },
      {"sway", "2-D", "tank.width"});
  expect_refused([](Parameters& p) { p.motion.type = MotionType::file; }, {"motion.type = file", "motion.file"});
  expect_refused(
      [](Parameters& p) {
        p.motion.type = MotionType::harmonic;
        p.motion.harmonic.of = DegreeOfFreedom::roll;
        p.motion.file = "a.csv";
      },
      {"motion.type = roll", "motion.file"});
  Parameters p;  // A tank at rest for once keeps what moves it otherwise.
  p.motion.harmonics.resize(1);
  p.motion.file = "a.csv";
  EXPECT_NO_THROW(check_parameters(p));
}

Parameters::TimeSeries rolling(std::vector<double> time, std::vector<double> roll) {
  Parameters::TimeSeries series{.time = std::move(time), .values = {}};
  series[DegreeOfFreedom::roll] = std::move(roll);
  return series;
}

TEST(CheckParameters, WantsASeriesThatIsWholeAndAsLongAsTheRun) {
  Parameters p;
  p.time.end = 3;
  p.motion = {.type = MotionType::file, .series = rolling({0, 1, 2, 3}, {0, 1, 0, 1})};
  EXPECT_NO_THROW(check_parameters(p));
  const auto refused = [&](const Parameters::TimeSeries& series, double end) {
    Parameters bad = p;
    bad.motion.series = series;
    bad.time.end = end;
    EXPECT_THROW(check_parameters(bad), BadParameters);
  };
  refused(p.motion.series, 3.1);
  refused(rolling({0.1, 1, 2, 3}, {0, 1, 0, 1}), 3);
  refused(rolling({0, 1, 1, 3}, {0, 1, 0, 1}), 3);
  refused(rolling({0, 1, 2, 3}, {0, 1, 0}), 3);
  refused(rolling({0, 1, 2, 3}, {0, 1, 0, std::nan("")}), 3);
  refused(rolling({0, 1, 3}, {0, 1, 0}), 3);
}

TEST(CheckParameters, LimitsTheNumberOfParticles) {
  expect_refused([](Parameters& p) { p.particles.spacing = 1e-5; }, {"particles.spacing = 1e-05 m", "1e8"});
}

TEST(Preset, PaperIsThePapersScheme) {
  Parameters p;
  apply_preset(p, Preset::paper);
  EXPECT_EQ(p.preset, Preset::paper);
  EXPECT_EQ(p.method.kernel, "KF3");
  EXPECT_EQ(p.method.order, Order::move_first);
  EXPECT_EQ(p.method.source, SourceTerm::density);
  EXPECT_EQ(p.method.gradient, GradientModel::minimum);
  EXPECT_EQ(p.method.surface, SurfaceTest::density);
  EXPECT_EQ(p.method.separation, SeparationModel::part);
  EXPECT_EQ(p.method.separation_distance, 0.5);
  EXPECT_EQ(p.method.shift, 0);
  EXPECT_EQ(p.method.wall, WallSlip::none);
  EXPECT_EQ(p.method.wall_model, WallModel::particles);
  EXPECT_EQ(p.time.courant, 0.1);
  EXPECT_EQ(p.pressure.solver, SolverName::iccg);
}

TEST(Preset, StabilisedTakesEverythingBack) {
  const Parameters fresh;
  Parameters p;
  apply_preset(p, Preset::paper);
  apply_preset(p, Preset::stabilised);
  EXPECT_EQ(p.preset, Preset::stabilised);
  EXPECT_EQ(p.method.kernel, fresh.method.kernel);
  EXPECT_EQ(p.method.radius_density, fresh.method.radius_density);
  EXPECT_EQ(p.method.radius_laplacian, fresh.method.radius_laplacian);
  EXPECT_EQ(p.method.order, Order::project_first);
  EXPECT_EQ(p.method.wall_model, WallModel::ghosts);
  EXPECT_EQ(p.method.source, SourceTerm::mixed);
  EXPECT_EQ(p.method.gradient, GradientModel::corrected);
  EXPECT_EQ(p.method.surface, SurfaceTest::density_and_count);
  EXPECT_EQ(p.method.separation, SeparationModel::collide);
  EXPECT_EQ(p.method.shift, fresh.method.shift);
  EXPECT_EQ(p.method.wall, fresh.method.wall);
  EXPECT_EQ(p.time.courant, fresh.time.courant);
  EXPECT_EQ(fresh.pressure.solver, SolverName::amg);
  EXPECT_EQ(p.pressure.solver, SolverName::amg);
}

TEST(Preset, LeavesTheCaseAlone) {
  Parameters p;
  p.fluid.depth = 0.3;
  p.tank.length = 0.9;
  p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.01, 2}, .start = Start::smooth};
  p.time.end = 3;
  apply_preset(p, Preset::paper);
  EXPECT_EQ(p.fluid.depth, 0.3);
  EXPECT_EQ(p.tank.length, 0.9);
  EXPECT_EQ(p.motion.harmonic.amplitude, 0.01);
  EXPECT_EQ(p.time.end, 3);
}

}  // namespace
}  // namespace seiche
