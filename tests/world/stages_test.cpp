// Where the time of a step goes can be looked at without changing the step.

#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

#include "scenes/catalogue.h"
#include "state/stage_clock.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr int kSteps = 60;

TEST(Stages, AreNotClockedUnlessAskedFor) {
  World world = makeScene(findScene("T1"), 25);
  const auto simulation = makeSimulation();
  EXPECT_EQ(simulation->stageTimes(), nullptr);
  simulation->step(world);
  EXPECT_EQ(simulation->stageTimes(), nullptr);
}

TEST(Stages, ChangeNoBitOfAHeap) {
  World clocked = makeScene(findScene("T1"), 300);
  World other = clocked;
  const auto simulation = makeSimulation();
  const auto unclocked = makeSimulation();
  ASSERT_TRUE(simulation->openStageClock());
  for (int step = 0; step < kSteps; ++step) {
    simulation->step(clocked);
    unclocked->step(other);
  }
  EXPECT_EQ(stateHash(clocked), stateHash(other));
}

TEST(Stages, OfAHeapAddUpToNoMoreThanTheStep) {
  World world = makeScene(findScene("T1"), 300);
  const auto simulation = makeSimulation();
  simulation->openStageClock();
  StageTimes sum{};
  for (int step = 0; step < kSteps; ++step) {
    const auto before = std::chrono::steady_clock::now();
    simulation->step(world);
    const std::chrono::duration<double> around = std::chrono::steady_clock::now() - before;
    const StageTimes& times = *simulation->stageTimes();
    EXPECT_LE(std::accumulate(times.begin(), times.end(), 0.0), around.count() * (1 + 1e-12));
    for (std::size_t i = 0; i < times.size(); ++i) sum[i] += times[i];
  }
  for (const Stage stage : {Stage::Sleep, Stage::Candidates, Stage::Islands, Stage::Exact,
                            Stage::Flight, Stage::Prepare, Stage::Solve, Stage::Push})
    EXPECT_GT(sum[static_cast<std::size_t>(stage)], 0) << name(stage);
}

}  // namespace
}  // namespace wells
