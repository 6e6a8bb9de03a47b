// Each instant of a step belongs to one stage.
#include "state/stage_clock.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

namespace wells {
namespace {

using Clock = std::chrono::steady_clock;

/// Until the clock has moved on.
void pass() {
  const auto start = Clock::now();
  while (Clock::now() == start) continue;
}

double at(const StageClock& clock, Stage stage) {
  return clock.times()[static_cast<std::size_t>(stage)];
}

TEST(StageClock, GivesEachInstantToOneStage) {
  StageClock clock;
  const auto before = Clock::now();
  clock.begin();
  {
    StageScope outer(&clock, Stage::Flight);
    pass();
    {
      const StageScope inner(&clock, Stage::Books);
      pass();
    }
    pass();
    outer.next(Stage::Solve);
    pass();
  }
  const auto ended = Clock::now();
  const double sum = std::accumulate(clock.times().begin(), clock.times().end(), 0.0);
  EXPECT_LE(sum, std::chrono::duration<double>(ended - before).count() * (1 + 1e-12));
  for (const Stage stage : {Stage::Flight, Stage::Books, Stage::Solve}) {
    EXPECT_GT(at(clock, stage), 0) << name(stage);
    EXPECT_LT(at(clock, stage), sum) << name(stage);
  }
  EXPECT_EQ(at(clock, Stage::Candidates), 0);
}

TEST(StageClock, GoesOnWithTheStageBeforeWhenAScopeEnds) {
  StageClock clock;
  clock.begin();
  EXPECT_EQ(clock.enter(Stage::Solve), Stage::Other);
  { const StageScope inner(&clock, Stage::Books); }
  EXPECT_EQ(clock.enter(Stage::Push), Stage::Solve);
}

TEST(StageClock, ForgetsTheStepBefore) {
  StageClock clock;
  clock.begin();
  {
    const StageScope stage(&clock, Stage::Solve);
    pass();
  }
  clock.begin();
  EXPECT_EQ(clock.times(), StageTimes{});
}

TEST(StageScope, NeedsNoClock) {
  StageScope stage(nullptr, Stage::Solve);
  stage.next(Stage::Push);
}

TEST(Stages, HaveNamesOfTheirOwn) {
  EXPECT_EQ(std::set(kStageNames.begin(), kStageNames.end()).size(), kStageNames.size());
  EXPECT_EQ(name(Stage::Other), kStageNames.back());
  EXPECT_EQ(name(Stage::Exact), "exact");
}

}  // namespace
}  // namespace wells
