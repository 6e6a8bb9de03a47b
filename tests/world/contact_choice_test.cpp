#include "world/contact_choice.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "world/measures.h"
#include "world/simulation.h"

namespace wells {
namespace {

struct Island {
  Settings settings;
  Balls balls;
  std::vector<std::uint32_t> ids;
  std::vector<std::uint8_t> stepsInSubsteps;

  explicit Island(std::size_t count, std::uint8_t steps = 1) : ids(count) {
    std::iota(ids.begin(), ids.end(), 0u);
    stepsInSubsteps.assign(count, 0);
    stepsInSubsteps.back() = steps;
    for (std::size_t i = 0; i < count; ++i)
      balls.add({.position = {static_cast<double>(i), 1, 0}}, 0.5, 1);
  }

  bool isCrowd() const { return wells::isCrowd(settings, ids, balls, stepsInSubsteps); }
};

TEST(ContactChoice, ManyBallsAreACrowdOnlyWhereContactsLasted) {
  EXPECT_TRUE(Island(10 * kCrowd, 1).isCrowd());
  EXPECT_FALSE(Island(10 * kCrowd, 0).isCrowd());
}

TEST(ContactChoice, ACrowdRemainsOneUntilItIsHalfAsLarge) {
  EXPECT_TRUE(Island(kCrowd / 2 + 1).isCrowd());
  EXPECT_FALSE(Island(kCrowd / 2).isCrowd());
}

TEST(ContactChoice, ElasticBallsWithoutFrictionAreNeverOne) {
  Island island(10 * kCrowd);
  island.settings.elasticity = 1;
  island.settings.friction = 0;
  EXPECT_FALSE(island.isCrowd());
  island.settings.friction = 0.1;
  EXPECT_TRUE(island.isCrowd());
}

TEST(ContactChoice, NeitherIsAnIslandWithAFastBall) {
  Island island(10 * kCrowd);
  const double radiusASubstep = 0.5 / (island.settings.dt / island.settings.substeps);
  island.balls.velocity[3] = {0, 0, 1.01 * radiusASubstep};
  EXPECT_FALSE(island.isCrowd());
  island.balls.velocity[3] = {0, 0, 0.99 * radiusASubstep};
  EXPECT_TRUE(island.isCrowd());
}

/// A ball between the wall and a heavy one that comes: 314 impacts, most of them in few steps.
World manyImpacts(ContactMethod method) {
  World world;
  world.settings.gravity = Vec3::Zero();
  world.settings.elasticity = 1;
  world.settings.friction = 0;
  world.settings.contactMethod = method;
  world.settings.mostImpacts = 50;
  world.arena.radius = 10;
  // Creeps along the wall, and is moved before the others' step is given up.
  world.balls.add({.position = {-9.4, 1, 0}, .velocity = {0, 0, 0.01}}, 0.5, 1);
  world.balls.add({.position = {8.5, 1, 0}}, 0.5, 1);
  world.balls.add({.position = {6.5, 1, 0}, .velocity = {40, 0, 0}}, 0.5, 1e4);
  return world;
}

/// Two blocks of 40 balls with gaps of 0.1 m that drift apart. In each, two balls overlap at first:
/// that is for the substeps.
World partingBlocks() {
  World world;
  world.settings.gravity = Vec3::Zero();
  for (const double side : {-1.0, 1.0}) {
    for (int x = 0; x < 10; ++x)
      for (int y = 0; y < 4; ++y)
        world.balls.add(
            {.position = {side * (0.55 + 1.1 * x), 1 + 1.1 * y, 0}, .velocity = {side * 0.4, 0, 0}},
            0.5, 1);
    world.balls.position.back().y() -= 0.11;
  }
  return world;
}

TEST(ContactChoice, IsRememberedFromStepToStep) {
  World world = partingBlocks();
  const auto simulation = makeSimulation();
  simulation->step(world);
  EXPECT_EQ(simulation->counts().handedOver, 1);
  EXPECT_EQ(simulation->counts().substepBalls, 80) << "one crowd";
  for (int step = 0; step < kCrowdSteps; ++step) {
    simulation->step(world);
    EXPECT_EQ(simulation->counts().handedOver, 0);
    EXPECT_EQ(simulation->counts().substepBalls, 80) << "and two halves of it, 0.5 m apart";
  }
  simulation->step(world);
  EXPECT_EQ(simulation->counts().exactBalls, 80) << "nothing overlaps any more";
}

// A heap is tried once, and then not for kCrowdSteps steps.
TEST(ContactChoice, AHeapIsSeldomTried) {
  World world;
  world.settings.sleepSpeed = 0;
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 4; ++y)
      for (int z = 0; z < 5; ++z)
        world.balls.add({.position = {x + 0.0, 0.5 + y, z + 0.0}}, 0.5, 1);
  const auto simulation = makeSimulation();
  for (int step = 0; step < 3 * (kCrowdSteps + 1); ++step) {
    simulation->step(world);
    ASSERT_EQ(simulation->counts().substepBalls, 100);
    ASSERT_EQ(simulation->counts().handedOver, step % (kCrowdSteps + 1) == 0 ? 1 : 0) << step;
  }
}

TEST(MostImpacts, StopsAnExactStepAndLeavesTheWorldAsItWas) {
  World world = manyImpacts(ContactMethod::Exact);
  const auto simulation = makeSimulation();
  std::uint64_t before = 0;
  std::string error;
  for (int step = 0; step < 60 && error.empty(); ++step) {
    before = stateHash(world);
    try {
      simulation->step(world);
    } catch (const std::runtime_error& stop) {
      error = stop.what();
    }
  }
  EXPECT_NE(error.find("more than 50 elastic impacts in one step"), std::string::npos) << error;
  EXPECT_NE(error.find("MostImpacts"), std::string::npos) << error;
  EXPECT_EQ(stateHash(world), before);
  // With more allowed it goes on from there as if nothing had been.
  world.settings.mostImpacts = 1000;
  std::int64_t impacts = 0;
  for (int step = 0; step < 60; ++step) {
    simulation->step(world);
    impacts += simulation->counts().impacts;
  }
  EXPECT_GT(impacts, 300);
  EXPECT_NEAR(measure(world).kineticEnergy / (8e6 + 5e-5), 1, 1e-12);
}

TEST(MostImpacts, LetsAutoLeaveTheStepToTheSubsteps) {
  World world = manyImpacts(ContactMethod::Auto);
  const auto simulation = makeSimulation();
  std::int64_t handedOver = 0;
  for (int step = 0; step < 60; ++step) {
    simulation->step(world);
    handedOver += simulation->counts().handedOver;
  }
  EXPECT_GT(handedOver, 0);
  EXPECT_EQ(measure(world).escaped, 0);
}

}  // namespace
}  // namespace wells
