// Whole steps: what the parts do together, and how the stepper treats its World.
#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "reference/reference.h"

namespace wells {
namespace {

World arenaWithoutWells() {
  World world;
  world.settings.friction = 0.3;
  world.arena = {.radius = 20};
  return world;
}

void run(Stepper& stepper, World& world, int steps) {
  for (int i = 0; i < steps; ++i) stepper.step(world);
}

TEST(ReferenceStepper, NamesFindTheirVariants) {
  for (const auto name : referenceNames()) {
    const auto variant = referenceVariant(name);
    ASSERT_TRUE(variant.has_value()) << name;
    EXPECT_EQ(makeReference(*variant)->name(), name);
  }
  EXPECT_EQ(makeReference(ReferenceVariant::RungeKutta)->name(), "reference-rk");
  EXPECT_EQ(referenceVariant("ours"), std::nullopt);
}

// e = 0.5 leaves the ball that comes (1 - e)/2 of its speed, and gives the other (1 + e)/2.
TEST(ReferenceStepper, HeadOnImpactOfEqualBalls) {
  for (const auto name : referenceNames()) {
    World world = arenaWithoutWells();
    world.settings.gravity.setZero();
    world.settings.elasticity = 0.5;
    world.balls.add({.position = {0, 5, 0}, .velocity = {3, 0, 0}}, 0.5, 1);
    world.balls.add({.position = {1.2, 5, 0}}, 0.5, 1);
    const auto stepper = makeReference(*referenceVariant(name));
    run(*stepper, world, 20);
    EXPECT_NEAR(world.balls.velocity[0].x(), 0.75, 1e-14) << name;
    EXPECT_NEAR(world.balls.velocity[1].x(), 2.25, 1e-14) << name;
    EXPECT_EQ(world.step, 20) << name;
  }
}

// The force found in one step acts in the next: v (1 - mu g h) a step after the first.
TEST(ReferenceFlaws, RollingSlowsDownExponentially) {
  for (const double speed : {1.0, 4.0}) {
    World world = arenaWithoutWells();
    world.balls.add({.position = {0, 0.499, 0}, .velocity = {speed, 0, 0}}, 0.5, 2);
    const auto stepper = makeReference(ReferenceVariant::ImprovedEuler);
    run(*stepper, world, 61);
    // Coulomb's friction would have taken mu g t = 2.94 m/s off both.
    EXPECT_NEAR(world.balls.velocity[0].x(), speed * std::pow(1 - 0.3 * 9.81 / 60, 60), 1e-12);
  }
}

// In free fall a step of the published Runge-Kutta changes v by -3 g h and y by 3 v h - 25/12 g
// h^2, where 9/2 would keep the energy: it gains m g^2 h^2 (9/2 - 25/12) a step.
TEST(ReferenceFlaws, PublishedRungeKuttaGainsEnergyInFreeFall) {
  World world = arenaWithoutWells();
  world.balls.add({.position = {0, 15, 0}, .velocity = {0, 3, 0}}, 0.5, 2);
  const auto energy = [&] {
    return 2 * (9.81 * world.balls.position[0].y() + squaredLength(world.balls.velocity[0]) / 2);
  };
  const double before = energy();
  run(*makeReference(ReferenceVariant::RungeKutta), world, 20);
  EXPECT_NEAR(energy() - before, 20 * 2 * (9.81 / 60) * (9.81 / 60) * (4.5 - 25.0 / 12), 1e-10);
}

// A ball that counts as rolling has v_s = 0; its penetration is resolved all the same.
TEST(ReferenceStepper, ARestingBallStaysOnTheGround) {
  for (const auto variant :
       {ReferenceVariant::Euler, ReferenceVariant::ImprovedEuler, ReferenceVariant::RungeKutta,
        ReferenceVariant::Heun, ReferenceVariant::Rk4}) {
    World world = arenaWithoutWells();
    world.balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
    const auto stepper = makeReference(variant);
    run(*stepper, world, 100);
    EXPECT_NEAR(world.balls.position[0].y(), 0.5, 1e-12) << stepper->name();
  }
}

TEST(ReferenceFlaws, TheWallLetsABallInUpToItsCentre) {
  World world = arenaWithoutWells();
  world.settings.gravity.setZero();
  world.settings.elasticity = 0;
  world.balls.add({.position = {19.4, 5, 0}, .velocity = {12, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {-19.9, 5, 0}, .velocity = {-12, 0, 0}}, 0.5, 1);
  run(*makeReference(ReferenceVariant::Euler), world, 1);
  EXPECT_NEAR(world.balls.velocity[0].x(), 0, 1e-14);
  EXPECT_NEAR(world.balls.position[0].x(), 19.6, 1e-14) << "overlaps by 0.1, and stays there";
  EXPECT_NEAR(world.balls.position[1].x(), -20, 1e-14) << "pushed back to the wall's own radius";
}

TEST(ReferenceFlaws, PairsCountTwice) {
  World world = arenaWithoutWells();
  world.balls.add({.position = {0, 0.499, 0}}, 0.5, 1);
  world.balls.add({.position = {0.9, 0.499, 0}}, 0.5, 1);
  const auto stepper = makeReference(ReferenceVariant::ImprovedEuler);
  stepper->step(world);
  EXPECT_EQ(stepper->counts().contacts, 4) << "two on the ground, one pair";
}

TEST(ReferenceStepper, IterationsAreASetting) {
  World world = arenaWithoutWells();
  world.balls.add({.position = {0, 0.5, 0}, .velocity = {0, -3, 0}}, 0.5, 1);
  World untouched = world;
  run(*makeReference(ReferenceVariant::Euler), world, 1);
  run(*makeReference(ReferenceVariant::Euler, {.iterations = 0}), untouched, 1);
  EXPECT_GT(world.balls.velocity[0].y(), 0);
  EXPECT_LT(untouched.balls.velocity[0].y(), -3);
}

// After a change from outside, the previous step's velocity belongs to another history: the next
// step is p += v h + a h^2/2 again, as a first step is.
TEST(ReferenceStepper, AChangeFromOutsideStartsTheBallAfresh) {
  World world = arenaWithoutWells();
  world.balls.add({.position = {0, 10, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {5, 10, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  const auto stepper = makeReference(ReferenceVariant::ImprovedEuler);
  run(*stepper, world, 2);
  world.balls.setState(0, {.position = {0, 10, 0}, .velocity = {7, 0, 0}});
  const Vec3 other = world.balls.position[1];
  const double fallSpeed = 2 * 9.81 / 60;
  run(*stepper, world, 1);
  EXPECT_NEAR(world.balls.position[0].x(), 7.0 / 60, 1e-14);
  EXPECT_NEAR(world.balls.position[0].y(), 10 - 9.81 / 7200, 1e-14);
  // The other ball averages with what it had a step before: h (v - g h/2) - g h^2/2.
  EXPECT_NEAR(world.balls.position[1].y() - other.y(), -fallSpeed / 60, 1e-14);
}

TEST(ReferenceStepper, GhostsAreMovedAndSpinIsLeftAlone) {
  World world = arenaWithoutWells();
  world.balls.add({.position = {0, 10, 0}, .velocity = {1, 0, 0}, .spin = {1, 2, 3}}, 0.5, 1);
  world.roles = {Role::Ghost};
  run(*makeReference(ReferenceVariant::Heun), world, 60);
  EXPECT_NEAR(world.balls.position[0].x(), 1, 1e-14);
  EXPECT_EQ(world.balls.spin[0], Vec3(1, 2, 3));
}

World crowd(const Vec3& center) {
  World world = arenaWithoutWells();
  world.arena = {.center = center, .radius = 6};
  world.tracks = {{.keyframes = {{.position = center + Vec3(2, 0.5, 0), .strength = 20}}}};
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const Vec3 place{random.uniform(-3, 3), random.uniform(1, 9), random.uniform(-3, 3)};
    world.balls.add({.position = center + place, .velocity = random.direction()}, 0.4, 1);
  }
  return world;
}

TEST(ReferenceStepper, ACrowdStaysFiniteAndRepeatsItsBits) {
  for (const auto name : referenceNames()) {
    World world = crowd(Vec3::Zero());
    World again = world;
    run(*makeReference(*referenceVariant(name)), world, 120);
    run(*makeReference(*referenceVariant(name)), again, 120);
    EXPECT_EQ(world.balls.position, again.balls.position) << name;
    EXPECT_EQ(world.balls.velocity, again.balls.velocity) << name;
    for (const Vec3& position : world.balls.position) EXPECT_TRUE(isFinite(position)) << name;
  }
}

// The bound is far above what rounding does at a distance of 2 km, and far below what a formula
// would do that forgot the centre.
TEST(ReferenceStepper, TheArenaMayStandAnywhere) {
  const auto scene = [](const Vec3& center) {
    World world = arenaWithoutWells();
    world.settings.dt = 1.0 / 64;
    world.settings.gravity = {0, -8, 0};
    world.settings.elasticity = 0.5;
    world.arena = {.center = center, .radius = 8};
    world.balls.add({.position = center + Vec3(7, 1, 0), .velocity = {8, -4, 0}}, 0.5, 1);
    world.balls.add({.position = center + Vec3(0, 1, 0), .velocity = {0, -1, 2}}, 0.5, 1);
    return world;
  };
  World here = scene(Vec3::Zero());
  World there = scene({1024, -512, 2048});
  run(*makeReference(ReferenceVariant::ImprovedEuler), here, 32);
  run(*makeReference(ReferenceVariant::ImprovedEuler), there, 32);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT(length(there.balls.position[i] - there.arena.center - here.balls.position[i]), 1e-9);
    EXPECT_LT(length(there.balls.velocity[i] - here.balls.velocity[i]), 1e-9);
  }
  EXPECT_LT(here.balls.velocity[0].x(), 0) << "it has met the wall";
}

}  // namespace
}  // namespace wells
