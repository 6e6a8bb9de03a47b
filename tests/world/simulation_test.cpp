#include "world/simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "scenes/catalogue.h"
#include "world/measures.h"
#include "world/prediction.h"

namespace wells {
namespace {

std::uint64_t hashAfter(World world, int steps) {
  const auto simulation = makeSimulation();
  for (int i = 0; i < steps; ++i) simulation->step(world);
  return stateHash(world);
}

TEST(Simulation, SameBitsTwice) {
  EXPECT_EQ(hashAfter(makeScene(findScene("T1"), 500), 120),
            hashAfter(makeScene(findScene("T1"), 500), 120));
}

// The candidate pairs depend on the history of Bullet's boxes; the result must not: a simulation
// that starts afresh at every step has no history (and no impulses to start from, so friction and
// heaps are left out here).
TEST(Simulation, ResultDoesNotDependOnTheHistoryOfTheBroadphase) {
  World kept = makeScene(findScene("T2"), 300);
  World fresh = kept;
  const auto simulation = makeSimulation();
  for (int i = 0; i < 200; ++i) {
    simulation->step(kept);
    makeSimulation()->step(fresh);
    ASSERT_EQ(stateHash(kept), stateHash(fresh)) << "step " << i;
  }
}

TEST(Simulation, ResultDoesNotDependOnTheKindOfBroadphase) {
  for (const auto& [name, balls] : {std::pair{"T1", 400}, {"T2", 300}, {"template", 25}}) {
    World world = makeScene(findScene(name), static_cast<std::size_t>(balls));
    std::uint64_t hashes[3] = {};
    for (const auto kind : {BroadphaseKind::Auto, BroadphaseKind::Tree, BroadphaseKind::Grid}) {
      world.settings.broadphase = kind;
      hashes[static_cast<int>(kind)] = hashAfter(world, 150);
    }
    EXPECT_EQ(hashes[0], hashes[1]) << name;
    EXPECT_EQ(hashes[0], hashes[2]) << name;
  }
}

TEST(Simulation, NoPairComesTooLate) {
  for (const auto& [name, balls] : {std::pair{"T1", 1000}, {"T2", 1000}, {"template", 200}}) {
    World world = makeScene(findScene(name), static_cast<std::size_t>(balls));
    const auto simulation = makeSimulation();
    for (int i = 0; i < 150; ++i) {
      simulation->step(world);
      ASSERT_EQ(simulation->counts().latePairs, 0) << name << " step " << i;
    }
  }
}

TEST(Simulation, EqualSizedWorldFarAwayBehavesTheSame) {
  World world = makeScene(findScene("billiard"));
  World far = world;
  const Vec3 offset{4096, 1024, -2048};  // exact in binary, so only rounding of sums differs
  far.arena.center += offset;
  for (Vec3& x : far.balls.position) x += offset;
  const auto a = makeSimulation();
  const auto b = makeSimulation();
  for (int i = 0; i < 180; ++i) {
    a->step(world);
    b->step(far);
  }
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LE(length(far.balls.position[i] - offset - world.balls.position[i]), 1e-9);
}

TEST(Simulation, BallThatIsNotFiniteHarmsNobodyElse) {
  World clean = makeScene(findScene("template"), 60);
  World spoiled = clean;
  spoiled.balls.add({.position = {std::nan(""), 1, 1}}, 0.5, 1);
  clean.balls.add({.position = {0, 1000, 0}}, 0.5, 1);  // far above: touches nobody either
  const auto a = makeSimulation();
  const auto b = makeSimulation();
  for (int i = 0; i < 60; ++i) {
    a->step(clean);
    b->step(spoiled);
  }
  for (std::size_t i = 0; i < 60; ++i)
    EXPECT_EQ(clean.balls.position[i], spoiled.balls.position[i]) << i;
}

// A well that moves uniformly is one at rest seen from a moving frame; on smooth ground, so that
// the ball is in contact and its step is taken in substeps.
TEST(Simulation, SubstepsSeeAMovingWellWhereItIs) {
  const Vec3 u{3, 0, -2};
  World rest;
  rest.settings.friction = 0;
  rest.tracks = {{.keyframes = {{0, {5, 0.5, 0}, 60}}}};
  rest.balls.add({.position = {0, 0.5, 0}, .velocity = {0, 0, 2}}, 0.5, 1);
  World moving = rest;
  moving.tracks[0].keyframes.push_back({240, Vec3(5, 0.5, 0) + 4 * u, 60});
  moving.balls.velocity[0] += u;
  const auto a = makeSimulation();
  const auto b = makeSimulation();
  for (int i = 0; i < 240; ++i) {
    a->step(rest);
    b->step(moving);
  }
  EXPECT_LE(length(moving.balls.position[0] - 4 * u - rest.balls.position[0]), 1e-11);
}

// Ghosts: pairs of them pass through each other, an owned ball meets them.
TEST(Ghosts, TouchOwnedBallsOnly) {
  for (const Role other : {Role::Owned, Role::Ghost}) {
    World world = makeScene(findScene("billiard"));
    world.roles = {other, Role::Ghost, Role::Ghost};
    const auto simulation = makeSimulation();
    for (int i = 0; i < 60; ++i) simulation->step(world);
    const bool hit = world.balls.velocity[1] != Vec3(0, 0, 0);
    EXPECT_EQ(hit, other == Role::Owned);
  }
}

// Two ghosts on top of each other, under gravity: what holds the upper one is its owner's to know,
// so both keep their velocity; alone, the upper one falls.
TEST(Ghosts, ThatTouchEachOtherDrift) {
  for (const double gap : {0.01, 3.0}) {
    World world;
    world.balls.add({.position = {0, 5, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
    world.balls.add({.position = {0, 6 + gap, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
    world.roles = {Role::Ghost, Role::Ghost};
    const auto simulation = makeSimulation();
    for (int i = 0; i < 6; ++i) simulation->step(world);
    EXPECT_NEAR(world.balls.position[1].x(), 0.1, 1e-15);
    EXPECT_NEAR(world.balls.velocity[1].y(), gap < 1 ? 0 : -0.981, 1e-15);
  }
}

// A ball that touches no other is predicted with the owner's bits: in the air, bouncing, sliding,
// rolling, at the wall, under a moving well.
TEST(Prediction, HasTheBitsOfTheSimulation) {
  Random random(5);
  World world;
  world.arena.radius = 30;
  world.tracks = {
      {.keyframes = {{0, {10, 1, 0}, 150}, {100, {-10, 1, 5}, 90}, {170, {0, 2, 9}, 0}}}};
  // Far apart in x at first; the wells and walls move them about, so pairs are kept from meeting by
  // giving each world one ball only.
  for (int trial = 0; trial < 12; ++trial) {
    World one = world;
    one.balls.add({.position = 25 * random.direction() * random.uniform() + Vec3(0, 26, 0),
                   .velocity = 12 * random.direction(),
                   .spin = 20 * random.direction()},
                  0.5, 1.5);
    const BallState start = one.balls.state(0);
    const auto simulation = makeSimulation();
    for (int step = 0; step < 400; ++step) simulation->step(one);
    const BallState predicted = predict(one, 0, start, 0, 400);
    EXPECT_EQ(predicted.position, one.balls.position[0]) << trial;
    EXPECT_EQ(predicted.velocity, one.balls.velocity[0]) << trial;
    EXPECT_EQ(predicted.spin, one.balls.spin[0]) << trial;
  }
}

// The same in each method, and for a ball that a well presses into the corner of ground and wall,
// where contacts last; in substeps they start from remembered impulses.
TEST(Prediction, HasTheBitsOfTheSimulationInEachMethod) {
  for (const ContactMethod method :
       {ContactMethod::Substep, ContactMethod::Exact, ContactMethod::Auto})
    for (const char* integrator : {"symplectic-euler", "pefrl"}) {
      World world;
      world.arena.radius = 10;
      world.settings.contactMethod = method;
      world.settings.integrator = integrator;
      world.tracks = {{.keyframes = {{0, {12, 1, 0}, 300}}}};
      world.balls.add({.position = {5, 3, 2}, .velocity = {2, 0, -1}, .spin = {3, 4, 5}}, 0.5, 2);
      const BallState start = world.balls.state(0);
      const auto simulation = makeSimulation();
      std::int64_t inSubsteps = 0;
      for (int step = 0; step < 300; ++step) {
        simulation->step(world);
        inSubsteps += simulation->counts().substepBalls;
      }
      if (method == ContactMethod::Substep) {
        EXPECT_GT(inSubsteps, 20) << "the contact lasts";
      }
      const BallState predicted = predict(world, 0, start, 0, 300);
      EXPECT_EQ(predicted.position, world.balls.position[0]) << name(method) << " " << integrator;
      EXPECT_EQ(predicted.velocity, world.balls.velocity[0]) << name(method) << " " << integrator;
      EXPECT_EQ(predicted.spin, world.balls.spin[0]) << name(method) << " " << integrator;
    }
}

TEST(Prediction, OfNoStepsIsTheState) {
  World world = makeScene(findScene("bounce"));
  const BallState state = world.balls.state(0);
  EXPECT_EQ(predict(world, 0, state, 7, 7).position, state.position);
  EXPECT_EQ(predict(world, 0, state, 7, 3).position, state.position);
}

}  // namespace
}  // namespace wells
