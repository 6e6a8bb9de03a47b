// The simulator itself: the same seed gives the same run, what it finds shrinks, and seeds keep all
// promises.
#include "simulation/simulator.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "simulation/coverage.h"
#include "simulation/draw_schedule.h"
#include "simulation/run_seeds.h"
#include "simulation/shrink.h"

namespace wells::simulation {
namespace {

TEST(Simulator, TheSameSeedGivesTheSameLogByteForByte) {
  for (const std::uint64_t seed : {3u, 4u, 5u}) {
    const Outcome once = simulate(drawSchedule(seed, {}), Trace::Keeping::Everything);
    const Outcome again = simulate(drawSchedule(seed, {}), Trace::Keeping::Everything);
    EXPECT_GT(once.trace.size(), 1000u);
    EXPECT_EQ(once.trace, again.trace);
  }
}

TEST(Simulator, KeepingALogChangesNothing) {
  const Outcome silent = simulate(drawSchedule(6, {}));
  const Outcome logged = simulate(drawSchedule(6, {}), Trace::Keeping::Everything);
  EXPECT_EQ(silent.trace, "");
  EXPECT_EQ(silent.tally.messagesSent, logged.tally.messagesSent);
  EXPECT_EQ(silent.tally.seconds, logged.tally.seconds);
  EXPECT_EQ(silent.tally.coverage, logged.tally.coverage);
}

TEST(Simulator, SeedsDiffer) {
  EXPECT_NE(simulate(drawSchedule(1, {}), Trace::Keeping::Everything).trace,
            simulate(drawSchedule(2, {}), Trace::Keeping::Everything).trace);
}

Schedule withoutFaults() {
  Schedule schedule;
  for (int slot = 0; slot < 3; ++slot)
    schedule.faults.push_back({.at = 0, .kind = FaultKind::Start, .slot = slot});
  return schedule;
}

TEST(Simulator, ARunWithoutFaultsHandsOverAndNeverAdopts) {
  const Outcome outcome = simulate(withoutFaults());
  EXPECT_TRUE(outcome.violations.empty());
  EXPECT_GT(outcome.tally.handovers, 200);
  EXPECT_EQ(outcome.tally.adoptions, 0);
  EXPECT_EQ(outcome.tally.doubledBallSeconds, 0);
  EXPECT_EQ(outcome.tally.messagesLostInBuffers, 0);
  EXPECT_EQ(outcome.tally.incomplete, 0);
  EXPECT_GT(outcome.tally.groupChecks, 1000);
}

TEST(Simulator, FaultsDoWhatTheySay) {
  const auto with = [](const Fault& fault) {
    Schedule schedule = withoutFaults();
    schedule.faults.push_back(fault);
    return simulate(schedule).tally;
  };
  EXPECT_GT(with({.at = 20, .kind = FaultKind::Crash, .slot = 1, .duration = 3}).adoptions, 0);
  EXPECT_GT(
      with({.at = 20, .kind = FaultKind::Isolate, .slot = 1, .duration = 8}).doubledBallSeconds,
      10);
  EXPECT_EQ(with({.at = 20, .kind = FaultKind::Stall, .slot = 1, .duration = 5}).fences, 1);
  EXPECT_EQ(with({.at = 20, .kind = FaultKind::StallMidTick, .slot = 1, .duration = 5}).fences, 1);
  EXPECT_EQ(with({.at = 20, .kind = FaultKind::Stall, .slot = 1, .duration = 0.5}).fences, 0);
  EXPECT_EQ(with({.at = 20, .kind = FaultKind::Reset}).resyncs, 2);
  EXPECT_GT(with({.at = 20, .kind = FaultKind::Forge}).messagesRefused,
            with({.at = 20, .kind = FaultKind::Setting, .amount = 0.5}).messagesRefused);
  EXPECT_GT(with({.at = 20, .kind = FaultKind::TinyBuffer, .slot = 1, .amount = 4, .duration = 3})
                .messagesLostInBuffers,
            20);
  for (const FaultKind kind :
       {FaultKind::CrashBeforeOffer, FaultKind::CrashAfterOffer, FaultKind::CrashAfterAnswer}) {
    const Tally tally = with({.at = 20, .kind = kind, .slot = 1, .duration = 3});
    EXPECT_EQ(tally.faults[static_cast<std::size_t>(kind)], 1) << name(kind);
    EXPECT_GT(tally.adoptions, 0) << name(kind);
  }
}

// A group that is told to return while one of it cannot: the last peer starts just before the stop.
TEST(Simulator, WhatFailsIsShrunkToWhatItTakes) {
  Schedule failing = drawSchedule(1, {});
  std::erase_if(failing.faults, [](const Fault& fault) { return fault.slot == 2; });
  failing.stop = failing.heal + 1;
  failing.faults.push_back({.at = failing.heal, .kind = FaultKind::Start, .slot = 2});
  const Outcome outcome = simulate(failing);
  ASSERT_FALSE(outcome.violations.empty());
  ASSERT_EQ(outcome.violations.front().invariant, Invariant::AllReturn);
  const Schedule shrunk = shrink(failing, Invariant::AllReturn);
  EXPECT_LE(shrunk.faults.size(), 3u) << describe(shrunk);
  EXPECT_LE(shrunk.balls, 4);
  EXPECT_EQ(shrunk.latency, 0);
  EXPECT_EQ(simulate(shrunk).violations.front().invariant, Invariant::AllReturn);
}

TEST(Schedule, IsDrawnWithinItsBounds) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const Schedule schedule = drawSchedule(seed, {.peers = 5});
    EXPECT_EQ(schedule, drawSchedule(seed, {.peers = 5}));
    EXPECT_TRUE(std::ranges::is_sorted(schedule.faults, {}, &Fault::at));
    EXPECT_GE(schedule.stop, 60);
    for (const Fault& fault : schedule.faults) {
      EXPECT_LE(fault.at, schedule.heal);
      EXPECT_LT(fault.slot, 5);
      if (fault.kind == FaultKind::Loss) {
        EXPECT_LE(fault.amount, 0.3);
      }
      if (fault.kind == FaultKind::Duplication) {
        EXPECT_LE(fault.amount, 0.5);
      }
      if (fault.kind == FaultKind::Delay) {
        EXPECT_LE(fault.amount, 0.15);
      }
    }
  }
}

// Each of these holds for a share of the seeds, so that they can run side by side.
constexpr int kShares = 6;
constexpr std::int64_t kSeedsInShare = 180;

class Seeds : public testing::TestWithParam<int> {};

TEST_P(Seeds, KeepAllPromises) {
  const std::uint64_t first = 1 + static_cast<std::uint64_t>(GetParam() * kSeedsInShare);
  const SeedsOutcome outcome = runSeeds(first, kSeedsInShare, {}, 1, {});
  for (const Failure& failure : outcome.failures)
    ADD_FAILURE() << "seed " << failure.seed << " at " << failure.violation.time << " s, "
                  << name(failure.violation.invariant) << ": " << failure.violation.what;
  EXPECT_EQ(outcome.fewHandovers, std::vector<std::uint64_t>{});
  EXPECT_GE(outcome.tally.seconds, 60 * kSeedsInShare);
  EXPECT_EQ(outcome.tally.incomplete, 0);
  EXPECT_GT(outcome.tally.adoptions, kSeedsInShare);
}

INSTANTIATE_TEST_SUITE_P(Simulator, Seeds, testing::Range(0, kShares));

}  // namespace
}  // namespace wells::simulation
