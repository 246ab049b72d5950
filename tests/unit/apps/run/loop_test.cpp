#include "apps/run/loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "solver/errors.hpp"

namespace seiche::apps {
namespace {

// Steps of 0.03 s or what is left; fails on the step that starts at or after `fails_at`.
class FakeSimulation : public Simulation {
 public:
  explicit FakeSimulation(double fails_at = 1e9) : fails_at_(fails_at) {}
  void step(double until) override {
    if (time_ >= fails_at_) throw RunFailure({time_, 7, "it blew up"});
    time_ = until - time_ < 0.03 ? until : time_ + 0.03;
    ++statistics_.steps;
  }
  double time() const override { return time_; }
  const Statistics& statistics() const override { return statistics_; }
  FramePtr frame(long index) override {
    auto frame = std::make_shared<Frame>();
    frame->index = index;
    frame->time = time_;
    frame->pressure = {time_ >= fails_at_ ? last_pressure : 0};
    return frame;
  }

  float last_pressure = 1e6;  // of the state that it breaks off in

 private:
  double time_ = 0, fails_at_;
  Statistics statistics_;
};

// Notes what it is given; fails on frame number `fails_at`.
struct Log {
  bool began = false;
  std::vector<double> times;
  int ends = 0;
  std::string end_fails;
};
class FakeSink : public Sink {
 public:
  explicit FakeSink(Log& log, long fails_at = -1) : log_(log), fails_at_(fails_at) {}
  void begin(const RunInfo&) override { log_.began = true; }
  void frame(const FramePtr& frame) override {
    if (frame->index == fails_at_) throw std::runtime_error("the disk is full");
    log_.times.push_back(frame->time);
  }
  void end() override {
    ++log_.ends;
    if (!log_.end_fails.empty()) throw std::runtime_error(log_.end_fails);
  }

 private:
  Log& log_;
  long fails_at_;
};

struct LoopTest : testing::Test {
  LoopTest() {
    run.frame_interval = 0.1;
    run.end = 1;
  }
  Ending go(
      Simulation& simulation, const std::function<bool()>& stop = [] { return false; }) {
    Progress progress(Progress::Style::none);
    return run_loop(simulation, outputs, run, progress, stop);
  }
  RunInfo run;
  Log log;
  Outputs outputs;
};

TEST_F(LoopTest, FramesFallOnExactMultiplesOfTheInterval) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation;
  const Ending ending = go(simulation);
  EXPECT_EQ(ending.status, Ending::Status::finished);
  EXPECT_EQ(ending.frames, 11);
  EXPECT_EQ(ending.time, 1.0);
  ASSERT_EQ(log.times.size(), 11u);
  for (int k = 0; k < 10; ++k) EXPECT_EQ(log.times[k], k * 0.1);
  EXPECT_EQ(log.times.back(), 1.0);
  EXPECT_EQ(log.ends, 1);
}

TEST_F(LoopTest, TheLastFrameIsAtTheEndEvenIfThatIsNoMultiple) {
  run.end = 0.25;
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation;
  go(simulation);
  EXPECT_EQ(log.times, (std::vector<double>{0, 0.1, 0.2, 0.25}));
}

TEST_F(LoopTest, RoundingMakesNoFrameOfItsOwn) {
  run.end = 0.3;  // less than 3 * 0.1
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation;
  go(simulation);
  EXPECT_EQ(log.times, (std::vector<double>{0, 0.1, 0.2, 0.3}));
}

TEST_F(LoopTest, AFailureKeepsTheFramesBeforeItAndTheStateThatItBrokeOffIn) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation(0.45);
  const Ending ending = go(simulation);
  EXPECT_EQ(ending.status, Ending::Status::failed);
  ASSERT_TRUE(ending.failure);
  EXPECT_EQ(ending.failure->cause, "it blew up");
  EXPECT_EQ(ending.error, "");
  EXPECT_EQ(ending.frames, 6);
  ASSERT_EQ(log.times.size(), 6u);
  EXPECT_EQ(log.times[4], 0.4);
  EXPECT_DOUBLE_EQ(log.times[5], 0.46);
  EXPECT_EQ(ending.time, log.times[5]);
  EXPECT_EQ(log.ends, 1);
}

TEST_F(LoopTest, AStateThatIsNotFiniteIsNoFrame) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation(0.45);
  simulation.last_pressure = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(go(simulation).frames, 5);
  EXPECT_EQ(log.times.back(), 0.4);
}

TEST_F(LoopTest, AFailureRightAfterAFrameAddsNone) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation(0.4);
  EXPECT_EQ(go(simulation).frames, 5);
  EXPECT_EQ(log.times.back(), 0.4);
}

TEST_F(LoopTest, AStopFinishesTheCurrentFrame) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation;
  const Ending ending = go(simulation, [&] { return simulation.time() > 0.42; });
  EXPECT_EQ(ending.status, Ending::Status::interrupted);
  EXPECT_EQ(log.times.back(), 0.5);
  EXPECT_EQ(log.ends, 1);
}

TEST_F(LoopTest, AStopWithinTheLastFrameIsNone) {
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation;
  EXPECT_EQ(go(simulation, [&] { return simulation.time() > 0.95; }).status, Ending::Status::finished);
}

TEST_F(LoopTest, OneOutputsFailureEndsTheRunAndAllOutputs) {
  Log other;
  outputs.add("other", std::make_unique<FakeSink>(other));
  outputs.add("log", std::make_unique<FakeSink>(log, 3));
  FakeSimulation simulation;
  const Ending ending = go(simulation);
  EXPECT_EQ(ending.status, Ending::Status::failed);
  EXPECT_FALSE(ending.failure);
  EXPECT_EQ(ending.error, "the disk is full");
  EXPECT_EQ(ending.frames, 3);
  EXPECT_EQ(log.ends, 1);
  EXPECT_EQ(other.ends, 1);
}

TEST_F(LoopTest, AnOutputsFailureEndsARunOfAnyLength) {
  run.end = 1e7;  // would take until tomorrow
  outputs.add("log", std::make_unique<FakeSink>(log, 3));
  FakeSimulation simulation;
  const Ending ending = go(simulation);
  EXPECT_EQ(ending.status, Ending::Status::failed);
  EXPECT_FALSE(ending.failure);
  EXPECT_EQ(ending.error, "the disk is full");
  EXPECT_EQ(log.ends, 1);
}

TEST_F(LoopTest, FailuresOfTheRunAndOfAnOutputAreBothTold) {
  log.end_fails = "ffmpeg was killed";
  outputs.add("log", std::make_unique<FakeSink>(log));
  FakeSimulation simulation(0.25);
  const Ending ending = go(simulation);
  EXPECT_EQ(ending.status, Ending::Status::failed);
  EXPECT_EQ(ending.reason(), "stopped at t = 0.2600 s, step 7: it blew up; ffmpeg was killed");
  EXPECT_EQ(ending.frames, 4);
}

}  // namespace
}  // namespace seiche::apps
