#include "solver/step/watch.hpp"

#include <gtest/gtest.h>

#include "tests/unit/solver/still_tank.hpp"

namespace seiche::solver {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T, int D = T::D>
struct WatchOf : ::testing::Test {
  Parameters p = parameters();
  Motion motion{p.motion};
  Watch<D> watch{p, *make_shape<D>(p), motion};
  State<D> s = fill_tank<D>(p);

  static Parameters parameters() {
    Parameters p = test::small_tank<D>();
    p.motion = {.type = MotionType::harmonic, .harmonic = {DegreeOfFreedom::surge, 0.1, 1}, .start = Start::smooth};
    return p;
  }
  WatchOf() {
    s.time = 1.25;
    s.step = 345;
  }
  double limit() const {
    const double diagonal = std::sqrt(0.2 * 0.2 + 0.15 * 0.15 + (D == 3 ? 0.12 * 0.12 : 0));
    return 10 * (std::sqrt(2 * 9.81 * diagonal) + 0.2 * std::numbers::pi);
  }

  /// Expects `act` to fail with a message that has every one of the words, and the time and step.
  template <class F>
  static void expect_failure(F act, std::vector<std::string> words) {
    words.insert(words.end(), {"t = 1.2500 s", "step 345"});
    try {
      act();
      ADD_FAILURE() << "nothing was thrown";
    } catch (const RunFailure& failure) {
      EXPECT_EQ(failure.failure.time, 1.25);
      EXPECT_EQ(failure.failure.step, 345);
      for (const auto& word : words)
        EXPECT_NE(std::string(failure.what()).find(word), std::string::npos) << word << " in: " << failure.what();
    }
  }
};
TYPED_TEST_SUITE(WatchOf, test::Dimensions);

TYPED_TEST(WatchOf, GivesTheGreatestSpeed) {
  constexpr int D = TypeParam::D;
  EXPECT_EQ(this->watch.check_motion(this->s), 0);
  this->s.velocity[17] = 3 * test::slanted<D>().normalized();
  this->s.velocity[18] = -2 * Vec<D>::Unit(0);
  EXPECT_DOUBLE_EQ(this->watch.check_motion(this->s), 3);
}

TYPED_TEST(WatchOf, StopsAtWhatIsNotFinite) {
  const auto expect_stop = [&](auto spoil, const std::string& kind, int i) {
    auto spoiled = this->s;
    spoil(spoiled);
    this->expect_failure([&] { this->watch.check_motion(spoiled); },
                         {"not a finite number", kind + " particle " + std::to_string(i)});
  };
  expect_stop([](auto& state) { state.velocity[9][1] = nan; }, "fluid", 9);
  expect_stop([](auto& state) { state.velocity[9][0] = std::numeric_limits<double>::infinity(); }, "fluid", 9);
  expect_stop([](auto& state) { state.position[11][0] = nan; }, "fluid", 11);
  expect_stop([](auto& state) { state.pressure[12] = state.pressure[5] = nan; }, "fluid", 5);
  const auto wall = std::find(this->s.kind.begin(), this->s.kind.end(), Kind::wall) - this->s.kind.begin();
  expect_stop([&](auto& state) { state.pressure[wall] = nan; }, "wall", wall);
}

TYPED_TEST(WatchOf, SaysWhereInTheTank) {
  this->s.velocity[21][0] = nan;  // second row of 20, second column
  std::vector<std::string> where{"x = 0.015 m, y = 0.015 m"};
  if (TypeParam::D == 3) where.emplace_back("z = 0.005 m");
  this->expect_failure([&] { this->watch.check_motion(this->s); }, where);
}

TYPED_TEST(WatchOf, StopsBeyondTenTimesAFreeFall) {
  this->s.velocity[3][1] = -this->limit() * (1 - 1e-9);
  EXPECT_NO_THROW(this->watch.check_motion(this->s));
  this->s.velocity[3][1] = -this->limit() * (1 + 1e-9);
  this->expect_failure([&] { this->watch.check_motion(this->s); }, {"beyond the limit of", "fluid particle 3 at x ="});
}

TYPED_TEST(WatchOf, StopsWhenMoreThanATwentiethLeaked) {
  Statistics totals;
  totals.leaked = 10;
  EXPECT_NO_THROW(this->watch.check_leaks(this->s, totals, 200));
  totals.leaked = 11;
  this->expect_failure([&] { this->watch.check_leaks(this->s, totals, 200); }, {"11 of 200", "leaked", "5 %"});
  totals.leaked = 0;
  totals.spilled = 150;
  EXPECT_NO_THROW(this->watch.check_leaks(this->s, totals, 200)) << "what goes over the rim is no leak";
}

TYPED_TEST(WatchOf, StopsAfterAHundredShortStepsInARow) {
  const double wave = std::sqrt(9.81 * this->p.fluid.depth), cap = step_cap(this->p, wave), tiny = 0.999e-3 * cap;
  int short_steps = 0;
  for (int k = 0; k < 99; ++k) this->watch.check_step(this->s, tiny, short_steps);
  this->watch.check_step(this->s, 1.001e-3 * cap, short_steps);  // one longer step: the count begins anew
  for (int k = 0; k < 99; ++k) this->watch.check_step(this->s, tiny, short_steps);
  this->expect_failure([&] { this->watch.check_step(this->s, tiny, short_steps); }, {"time step", "for 100 steps"});
}

TYPED_TEST(WatchOf, NamesTheSourceWhereEveryParticleIsFinite) {
  EXPECT_NO_THROW(this->watch.check_source(this->s, true));
  this->expect_failure([&] { this->watch.check_source(this->s, false); }, {"source", "two particles in one place"});
}

TYPED_TEST(WatchOf, NamesTheParticleWhoseVelocityMadeTheSourceInfinite) {
  this->s.velocity[9][1] = nan;
  this->expect_failure([&] { this->watch.check_source(this->s, false); }, {"not a finite number", "fluid particle 9"});
}

TYPED_TEST(WatchOf, StopsWhereThePressureSolverDidNotConverge) {
  EXPECT_NO_THROW(this->watch.check_solve(this->s, {12, 1e-5, true}));
  this->expect_failure(
      [&] {
        this->watch.check_solve(this->s, {2000, 0.031, false});
      },
      {"'amg'", "2000 iterations", "0.031", "0.0001"});
}

}  // namespace
}  // namespace seiche::solver
