// Who falls asleep and who does not, who wakes and when; and that sleep changes nothing else.
#include "world/sleep.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "scenes/catalogue.h"
#include "scenes/crowds.h"
#include "scenes/piles.h"
#include "state/snapshot.h"
#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr double kWeight = 9.81;  // N, of a ball of 1 kg

/// A world and its engine.
struct Sleeper {
  explicit Sleeper(World start) : world(std::move(start)) {}

  void step(std::int64_t steps = 1) {
    for (std::int64_t i = 0; i < steps; ++i) simulation->step(world);
  }
  std::size_t asleep() const { return static_cast<std::size_t>(simulation->counts().asleep); }
  std::size_t awake() const { return world.balls.size() - asleep(); }

  World world;
  std::unique_ptr<Stepper> simulation = makeSimulation();
};

World sleepless(World world) {
  world.settings.sleepSpeed = 0;
  return world;
}

World settledLayer(std::size_t balls, ContactMethod method = ContactMethod::Exact) {
  World world = makeSettledLayer(balls, 1);
  world.settings.contactMethod = method;
  return world;
}

bool isSame(const BallState& a, const BallState& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin;
}

void expectSameBits(const World& a, const World& b) {
  for (std::size_t i = 0; i < a.balls.size(); ++i)
    EXPECT_TRUE(isSame(a.balls.state(i), b.balls.state(i))) << "ball " << i;
}

TEST(Sleep, HasTheSleeplessBitsUntilTheFirstFallsAsleep) {
  std::size_t fell = 0;
  for (const Scene& scene : scenes()) {
    const std::size_t balls = scene.fixedBalls == 0 && scene.defaultBalls > 100 ? 100 : 0;
    for (const ContactMethod method :
         {ContactMethod::Auto, ContactMethod::Exact, ContactMethod::Substep}) {
      SCOPED_TRACE(std::string(scene.name) + " " + std::string(name(method)));
      World world = makeScene(scene, balls);
      world.settings.contactMethod = method;
      Sleeper with(world);
      Sleeper without(sleepless(world));
      const std::int64_t steps = std::min<std::int64_t>(scene.defaultSteps, 200);
      while (with.world.step < steps) {
        with.step();
        if (with.asleep() > 0) break;
        without.step();
        ASSERT_EQ(stateHash(with.world), stateHash(without.world)) << with.world.step;
        ASSERT_EQ(without.asleep(), 0u);
      }
      if (with.asleep() > 0) ++fell;
    }
  }
  EXPECT_GE(fell, 5u) << "some scenes come to rest";
}

// All asleep: nothing is looked at, and nothing moves.
TEST(Sleep, ALayerAtRestStandsStillAndTakesNoWork) {
  for (const ContactMethod method :
       {ContactMethod::Auto, ContactMethod::Exact, ContactMethod::Substep}) {
    SCOPED_TRACE(name(method));
    Sleeper run(settledLayer(400, method));
    run.step(29);
    EXPECT_EQ(run.asleep(), 0u) << "not yet for half a second";
    run.step(1);
    ASSERT_EQ(run.asleep(), 400u);
    const World before = run.world;
    for (int step = 0; step < 300; ++step) {
      run.step();
      const StepCounts counts = run.simulation->counts();
      ASSERT_EQ(counts.asleep, 400);
      ASSERT_EQ(counts.candidatePairs + counts.contacts + counts.exactBalls + counts.substepBalls,
                0);
    }
    expectSameBits(run.world, before);
    EXPECT_EQ(measure(run.world).kineticEnergy, 0);
  }
}

TEST(Sleep, NeverComesWhereItIsSwitchedOff) {
  Sleeper run(sleepless(settledLayer(100)));
  run.step(200);
  EXPECT_EQ(run.asleep(), 0u);
}

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

// A ball beside the column, which touches nothing of it, is another island.
TEST(Sleep, IsByIsland) {
  World world = makeColumn(3, 1);
  world.balls.add({.position = {1.1, 0.5, 0}}, 0.5, 1);
  Sleeper run(world);
  run.step(60);
  ASSERT_EQ(run.asleep(), 4u);
  run.world.setState(3, {.position = {1.1, 0.5, 0}, .velocity = {1, 0, 0}});
  run.step();
  EXPECT_EQ(run.asleep(), 3u);
  run.world.setState(3, {.position = {1.2, 0.5, 0}, .velocity = {-1, 0, 0}});
  while (run.world.balls.velocity[3].x() < -0.5) {
    EXPECT_EQ(run.asleep(), 3u);
    run.step();
    ASSERT_LT(run.world.step, 200);
  }
  EXPECT_EQ(run.asleep(), 0u);
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

// Worlds that look as if they rested, for a while.
TEST(Sleep, DoesNotComeToWhatMoves) {
  World swings;  // 1e-7 m to and fro, 5e-8 m/s
  swings.balls.add({.position = {1e-7, 0.5, 0}}, 0.5, 1);
  swings.tracks = {{.keyframes = {{0, {0, 5, 0}, 50}}}};
  World drifts;
  drifts.settings.gravity.setZero();
  drifts.balls.add({.position = {0, 5, 0}, .velocity = {1e-9, 0, 0}}, 0.5, 1);
  drifts.balls.add({.position = {1.001, 5, 0}, .velocity = {1e-9, 0, 0}}, 0.5, 1);
  World spins;
  spins.balls.add({.position = {0, 0.5, 0}, .spin = {0, 1e-4, 0}}, 0.5, 1);
  World beside = makeColumn(2, 1);  // 1 mm from the top: neither could sleep for long
  beside.balls.add({.position = {1.001, 0.5, 0}, .spin = {0, 1, 0}}, 0.5, 1);
  World smooth = makeNudgedHeavyOnLight(0, 0);
  smooth.settings.friction = 0;
  const std::vector<std::pair<std::string, World>> cases = {
      {"a swing", swings},
      {"a drift", drifts},
      {"a top", spins},
      {"a column beside a top", beside},
      {"heavy on light, nudged", makeNudgedHeavyOnLight(0, 0)},
      {"the same without friction", smooth},
      {"a pile that slips", makeSlippingPile(0, 0)},
      {"a bounce", makeScene(findScene("bounce"))}};
  for (const auto& [about, world] : cases) {
    for (const ContactMethod method : {ContactMethod::Auto, ContactMethod::Substep}) {
      World chosen = world;
      chosen.settings.contactMethod = method;
      Sleeper run(chosen);
      for (int step = 0; step < 120; ++step) {
        run.step();
        ASSERT_EQ(run.asleep(), 0u) << about << ", " << name(method) << ", step " << step;
      }
    }
  }
}

// Forces are kept while a pile sleeps, so that it goes on as it was.
TEST(Sleep, KeepsTheForcesOfContact) {
  Sleeper run(makeColumn(4, 1));
  run.step(60);
  ASSERT_EQ(run.asleep(), 4u);
  const StepperMemory& memory = *run.simulation->memory();
  ASSERT_EQ(memory.ballContacts.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR(memory.ballContacts[k].normalImpulse / memory.substep,
                static_cast<double>(3 - k) * kWeight, 1e-8);
  const std::vector<Vec3> before = run.world.balls.position;
  run.world.setState(3, {.position = before[3], .velocity = {0, 1e-3, 0}});
  run.step();
  EXPECT_EQ(run.asleep(), 0u);
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LE(length(run.world.balls.position[k] - before[k]), 1e-6) << k;
}

TEST(Sleep, IsBooked) {
  World world = makeColumn(4, 1);
  for (std::size_t k = 0; k < 4; ++k)
    world.balls.position[k].y() += 0.05 * (static_cast<double>(k) + 1);
  world.settings.elasticity = 0.4;
  Sleeper run(world);
  run.simulation->openBooks();
  const Measures start = measure(world);
  while (run.asleep() < 4) {
    run.step();
    ASSERT_LT(run.world.step, 1200);
  }
  run.step(10);
  const Measures end = measure(run.world);
  const Books& books = *run.simulation->books();
  EXPECT_LE(books.sleep, 0);
  EXPECT_GE(books.sleep, -1e-9);
  const double scale = start.energy();
  EXPECT_NEAR(end.energy() - start.energy(), books.energy(), 1e-13 * scale);
  EXPECT_LE(length(end.momentum - start.momentum - books.impulse()), 1e-12 * scale);
  EXPECT_EQ(books.outside, 0);
}

}  // namespace
}  // namespace wells
