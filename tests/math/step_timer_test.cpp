#include "math/step_timer.h"

#include <gtest/gtest.h>

namespace wells {
namespace {

// Only lower bounds on time: a busy machine may be late, but a tick must never come early.
TEST(StepTimer, NeverTicksEarly) {
  StepTimer timer(500);
  const auto start = StepTimer::Clock::now();
  for (int i = 0; i < 51; ++i) timer.waitForNextTick();
  EXPECT_GE(StepTimer::Clock::now() - start, std::chrono::milliseconds(100));
  EXPECT_LE(timer.meanRate(), 500.5);
  EXPECT_GT(timer.meanRate(), 0);
}

TEST(StepTimer, WithoutTargetDoesNotWait) {
  StepTimer timer(0);
  for (int i = 0; i < 100000; ++i) timer.waitForNextTick();
  EXPECT_GT(timer.meanRate(), 0);
}

}  // namespace
}  // namespace wells
