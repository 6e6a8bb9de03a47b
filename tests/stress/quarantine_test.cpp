// Balls whose state is not finite: named, left alone, and without any effect on the others, down to
// the last bit.
#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "math/random.h"
#include "scenes/catalogue.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// 25 balls under a well, in motion and soon in contact.
World busyWorld() {
  World world = makeScene(findScene("template"), 25);
  world.arena.radius = 12;
  world.balls = {};
  Random random(5);
  for (int i = 0; i < 25; ++i)
    world.balls.add({.position = {2.0 * (i % 5) - 4, 0.7, 2.0 * (i / 5) - 4.0},
                     .velocity = 3 * random.direction()},
                    0.5, 1);
  return world;
}

std::vector<std::uint32_t> quarantinedBy(const Stepper& stepper) {
  const auto ids = stepper.quarantined();
  return {ids.begin(), ids.end()};
}

void expectSame(const BallState& a, const BallState& b, std::size_t ball) {
  EXPECT_EQ(a.position, b.position) << ball;
  EXPECT_EQ(a.velocity, b.velocity) << ball;
  EXPECT_EQ(a.spin, b.spin) << ball;
}

// Its id must not matter: here it is the first, so that all other ids move up by one.
TEST(Quarantine, FirstBallChangesNoBitOfTheOthers) {
  for (const auto method : {ContactMethod::Auto, ContactMethod::Exact, ContactMethod::Substep}) {
    World without = busyWorld();
    without.settings.contactMethod = method;
    World with = without;
    with.balls = {};
    with.balls.add({.position = {0, kNan, 0}}, 0.5, 1);
    for (std::size_t i = 0; i < without.balls.size(); ++i)
      with.balls.add(without.balls.state(i), 0.5, 1);

    const auto a = makeSimulation();
    const auto b = makeSimulation();
    for (int step = 0; step < 120; ++step) {
      a->step(without);
      b->step(with);
      ASSERT_EQ(quarantinedBy(*b), std::vector<std::uint32_t>{0});
      ASSERT_TRUE(a->quarantined().empty());
    }
    for (std::size_t i = 0; i < without.balls.size(); ++i)
      expectSame(without.balls.state(i), with.balls.state(i + 1), i);
  }
}

// A ball spoilt on the way is named at the end of the next step, stays as it is, and takes part
// again once it has a finite state.
TEST(Quarantine, BeginsAndEndsWithTheState) {
  World world = busyWorld();
  const auto stepper = makeSimulation();
  for (int step = 0; step < 30; ++step) stepper->step(world);
  EXPECT_TRUE(stepper->quarantined().empty());

  const BallState sound = world.balls.state(7);
  BallState spoilt = sound;
  spoilt.spin.y() = -std::numeric_limits<double>::infinity();
  world.balls.setState(7, spoilt);
  for (int step = 0; step < 30; ++step) {
    stepper->step(world);
    ASSERT_EQ(quarantinedBy(*stepper), std::vector<std::uint32_t>{7});
    expectSame(world.balls.state(7), spoilt, 7);
  }

  world.balls.setState(7, {.position = {0, 8, 0}});
  stepper->step(world);
  EXPECT_TRUE(stepper->quarantined().empty());
  EXPECT_LT(world.balls.velocity[7].y(), 0) << "it falls again";
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    EXPECT_TRUE(isFinite(world.balls.position[i]) && isFinite(world.balls.velocity[i])) << i;
}

// All balls may be so.
TEST(Quarantine, HoldsAnyNumber) {
  World world = busyWorld();
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    world.balls.velocity[i].z() = i % 2 == 0 ? kNan : std::numeric_limits<double>::infinity();
  const auto stepper = makeSimulation();
  for (int step = 0; step < 10; ++step) stepper->step(world);
  EXPECT_EQ(stepper->quarantined().size(), world.balls.size());
}

}  // namespace
}  // namespace wells
