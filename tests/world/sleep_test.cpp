// Who falls asleep and who does not; and that sleep changes nothing else.
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

constexpr double kWeight = 9.81;  // N, of a ball of 1 kg

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
