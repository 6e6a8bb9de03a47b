// Who wakes, and when: in the step in which it must, as if it had not slept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "scenes/catalogue.h"
#include "scenes/piles.h"
#include "world/measures.h"
#include "world/sleep.h"
#include "world/sleeper.h"

namespace wells {
namespace {

std::vector<std::uint32_t> movedBalls(const World& now, const World& start) {
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < now.balls.size(); ++i)
    if (now.balls.position[i] != start.balls.position[i]) moved.push_back(i);
  return moved;
}

// A ball is taken out of a sleeping layer and thrown at it. Against the engine that never lets
// sleep: the same bits through several impacts, until that one leaves the whole layer to the
// substeps; in the end, the same balls have moved.
TEST(Sleep, AThrownBallWakesThoseThatItReachesAndNoOthers) {
  World start = settledLayer(900);
  start.settings.elasticity = 0.6;
  Sleeper with(start);
  Sleeper without(sleepless(start));
  with.step(60);
  without.step(60);
  ASSERT_EQ(with.asleep(), 900u);
  expectSameBits(with.world, without.world);
  const BallState thrown{.position = {-6.3, 3, 0.2}, .velocity = {9, -4, 0.5}};
  const std::uint32_t ball = 450;
  with.world.setState(ball, thrown);
  without.world.setState(ball, thrown);
  std::size_t most = 0;
  std::int64_t impacts = 0;
  bool areExact = true;
  for (int step = 0; step < 120; ++step) {
    with.step();
    without.step();
    most = std::max(most, with.awake());
    const StepCounts counts = with.simulation->counts();
    ASSERT_LE(counts.candidatePairs, 10 * static_cast<std::int64_t>(with.awake()) + 50)
        << "only those awake are looked at";
    areExact = areExact && without.simulation->counts().handedOver == 0;
    if (!areExact) continue;
    impacts += with.simulation->counts().impacts;
    ASSERT_EQ(with.simulation->counts().impacts, without.simulation->counts().impacts) << step;
    ASSERT_EQ(stateHash(with.world), stateHash(without.world)) << step;
  }
  EXPECT_GE(impacts, 4);
  const auto moved = movedBalls(with.world, start);
  EXPECT_EQ(moved, movedBalls(without.world, start));
  EXPECT_GE(moved.size(), 5u) << "the throw is to hit some";
  EXPECT_LE(most, 6 * moved.size()) << "with the neighbours that they might have hit";
  EXPECT_EQ(with.simulation->counts().latePairs, 0);
}

// The ball is so fast that it crosses the layer within a step.
TEST(Sleep, IsNotTunnelledThrough) {
  const World start = settledLayer(400);
  Sleeper with(start);
  Sleeper without(sleepless(start));
  with.step(40);
  without.step(40);
  const BallState thrown{.position = {-9.6, 0.5, 0}, .velocity = {2000, 0, 0}};
  const std::uint32_t ball = 0;
  with.world.setState(ball, thrown);
  without.world.setState(ball, thrown);
  with.step();
  without.step();
  EXPECT_EQ(stateHash(with.world), stateHash(without.world));
  EXPECT_GE(movedBalls(with.world, start).size(), 5u);
}

// A ball hits a sleeper off its centre, which hits another one in the same step, out of the way of
// the first.
TEST(Sleep, PassesAnImpactOnWithinTheStep) {
  World start;
  start.settings.gravity.setZero();
  start.settings.elasticity = 1;
  start.settings.contactMethod = ContactMethod::Exact;
  const double far = 1.2;
  start.balls.add({.position = {0, 5, 0}}, 0.5, 1);
  start.balls.add({.position = {far * std::sqrt(0.5), 5, far * std::sqrt(0.5)}}, 0.5, 1);
  start.balls.add({.position = {-5, 5, -std::sqrt(0.5)}}, 0.5, 1);
  Sleeper with(start);
  Sleeper without(sleepless(start));
  with.step(40);
  without.step(40);
  ASSERT_EQ(with.asleep(), 3u);
  for (Sleeper* run : {&with, &without}) {
    run->world.setState(2, {.position = {-1, 5, -std::sqrt(0.5)}, .velocity = {60, 0, 0}});
    run->step();
  }
  EXPECT_EQ(without.simulation->counts().impacts, 2);
  EXPECT_EQ(with.simulation->counts().impacts, 2);
  EXPECT_EQ(stateHash(with.world), stateHash(without.world));
}

// A well stands vertically above the only ball, which can rest then. The well moves away: the ball
// must roll in that very step.
TEST(Sleep, EndsInTheStepInWhichAWellMoves) {
  World world;
  world.balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
  world.tracks = {{.keyframes = {{0, {0, 6, 0}, 20}, {100, {0, 6, 0}, 20}, {160, {6, 6, 0}, 20}}}};
  Sleeper with(world);
  Sleeper without(sleepless(world));
  with.step(100);
  without.step(100);
  EXPECT_EQ(with.asleep(), 1u);
  for (int step = 0; step < 100; ++step) {
    with.step();
    without.step();
    ASSERT_EQ(with.asleep(), 0u);
    ASSERT_EQ(stateHash(with.world), stateHash(without.world)) << step;
  }
  EXPECT_GT(with.world.balls.position[0].x(), 0.1);
}

// A ball that stands still exactly feels the slightest pull: where it is held by nothing it would
// roll away, given time.
TEST(Sleep, OfALoneBallEndsWithTheSlightestChange) {
  World world;
  world.balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
  world.tracks = {{.keyframes = {{0, {0, 6, 0}, 20}, {50, {0, 6, 0}, 20}, {51, {1e-6, 6, 0}, 20}}}};
  Sleeper with(world);
  Sleeper without(sleepless(world));
  with.step(50);
  without.step(50);
  EXPECT_EQ(with.asleep(), 1u);
  with.step(200);
  without.step(200);
  EXPECT_EQ(stateHash(with.world), stateHash(without.world));
  EXPECT_GT(with.world.balls.position[0].x(), 1e-7);
}

// A well that only acts far away does not wake a pile.
TEST(Sleep, OutlastsAWellThatHardlyActs) {
  World world = makeColumn(3, 1);
  world.tracks = {
      {.keyframes = {{0, {0, 1e4, 0}, 1}, {50, {0, 1e4, 0}, 1}, {90, {500, 1e4, 0}, 1}}}};
  Sleeper run(world);
  for (int step = 0; step < 120; ++step) {
    run.step();
    ASSERT_EQ(run.asleep(), step < 29 ? 0u : 3u) << step;
  }
}

TEST(Sleep, EndsForAllWhenASettingChanges) {
  const World start = settledLayer(100);
  const std::vector<std::function<void(World&)>> changes = {
      [](World& w) { w.settings.gravity.y() = 9.81; },
      [](World& w) { w.settings.friction = 0.1; },
      [](World& w) { w.settings.elasticity = 0.5; },
      [](World& w) { w.settings.dt = 0.01; },
      [](World& w) { w.settings.drag = 0.5; },
      [](World& w) { w.settings.substeps = 7; },
      [](World& w) { w.settings.sleepSpeed = 1e-6; },
      [](World& w) { w.settings.sleepSpeed = 0; },
      [](World& w) { w.arena.radius += 1; },
      [](World& w) { w.step += 5; },
      [](World& w) {
        w.balls.add({.position = {0, 9, 0}}, 0.5, 1);
      },
      [](World& w) { w.roles.assign(w.balls.size(), Role::Owned); }};
  for (std::size_t n = 0; n < changes.size(); ++n) {
    SCOPED_TRACE(n);
    Sleeper run(start);
    run.step(40);
    ASSERT_EQ(run.asleep(), 100u);
    changes[n](run.world);
    run.step();
    EXPECT_EQ(run.asleep(), 0u);
    if (n == 0) {
      for (const Vec3& v : run.world.balls.velocity) EXPECT_NEAR(v.y(), 9.81 / 60, 1e-15);
    }
  }
}

// The lowest ball of a column is pulled out: the others fall, at once.
TEST(Sleep, OfAColumnEndsWhenItsFootIsPulledOut) {
  Sleeper run(makeColumn(5, 1));
  run.step(60);
  ASSERT_EQ(run.asleep(), 5u);
  const std::vector<Vec3> before = run.world.balls.position;
  run.world.setState(0, {.position = {5, 0.5, 0}});
  run.step();
  EXPECT_EQ(run.asleep(), 0u);
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_NEAR(run.world.balls.position[i].y(), before[i].y() - 9.81 / 7200, 1e-12) << i;
}

// What was set to what it was may sleep on; a ball whose state stops being finite wakes its island.
TEST(Sleep, LooksAtWhatWasSet) {
  Sleeper run(makeColumn(3, 1));
  run.step(60);
  run.world.setState(1, run.world.balls.state(1));
  run.step();
  EXPECT_EQ(run.asleep(), 3u);
  BallState spoilt = run.world.balls.state(1);
  spoilt.spin.x() = std::nan("");
  run.world.setState(1, spoilt);
  run.step();
  EXPECT_EQ(run.asleep(), 0u);
  ASSERT_EQ(run.simulation->quarantined().size(), 1u);
}

// Another peer's ball in the middle of a column of ours.
TEST(Sleep, OfGhostsEndsWhenTheirOwnerMovesThem) {
  World world = makeColumn(3, 1);
  world.roles = {Role::Owned, Role::Ghost, Role::Owned};
  Sleeper run(world);
  run.step(60);
  ASSERT_EQ(run.asleep(), 3u);
  const BallState rest = run.world.balls.state(1);
  const double speed = run.world.settings.sleepSpeed;
  // Noise of the owner, as often as one likes.
  for (int i = 0; i < 100; ++i) {
    const double sign = i % 2 == 0 ? 1 : -1;
    BallState noisy = rest;
    noisy.position.x() += sign * 0.4 * speed;
    noisy.velocity.y() = -sign * 0.9 * speed;
    run.world.setState(1, noisy);
    run.step();
    ASSERT_EQ(run.asleep(), 3u);
    ASSERT_TRUE(isSame(run.world.balls.state(1), noisy)) << "it is where its owner says";
  }
  // Slow, but getting away.
  BallState away = rest;
  for (int i = 1; i <= 4; ++i) {
    away.position.x() = 0.2 * i * speed;
    run.world.setState(1, away);
    run.step();
    EXPECT_EQ(run.asleep(), i <= 2 ? 3u : 0u) << i;
  }
}

TEST(Sleep, EndsWhenABallChangesHands) {
  World world = makeColumn(3, 1);
  world.roles = {Role::Owned, Role::Ghost, Role::Owned};
  for (const std::size_t ball : {1u, 2u}) {
    Sleeper run(world);
    run.step(90);
    ASSERT_EQ(run.asleep(), 3u);
    run.world.setRole(ball, world.owns(ball) ? Role::Ghost : Role::Owned);
    run.step();
    EXPECT_EQ(run.asleep(), 0u);
  }
}

}  // namespace
}  // namespace wells
