// Stock Bullet on a World, against its own closed forms: symplectic Euler between contacts, and
// impulses of first order at them. Tolerances are single precision's unless said.
#include "baseline/bullet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/elementary.h"
#include "math/random.h"

namespace wells {
namespace {

void run(Stepper& stepper, World& world, int steps) {
  for (int i = 0; i < steps; ++i) stepper.step(world);
}

void run(World& world, int steps) {
  run(*makeBullet(), world, steps);
}

/// One ball of 0.5 m and 1 kg; no wells, dt = 1/60 s, g = 9.81 m/s^2.
World oneBall(const BallState& state) {
  World world;
  world.balls.add(state, 0.5, 1);
  return world;
}

// v_n = -g h n, y_n = y_0 - g h^2 n (n + 1) / 2.
TEST(Bullet, FallsBySymplecticEuler) {
  World world = oneBall({.position = {1, 20, 2}, .velocity = {0.5, 0, 0}});
  run(world, 60);
  EXPECT_NEAR(world.balls.position[0].x(), 1.5, 1e-5);
  EXPECT_NEAR(world.balls.position[0].y(), 20 - 9.81 / 3600 * 60 * 61 / 2, 1e-4);
  EXPECT_NEAR(world.balls.velocity[0].y(), -9.81, 1e-5);
  EXPECT_EQ(world.step, 60);
}

// a = S d / (d^2 + softening^2)^(3/2) = 250 * 3 / 125 = 6 m/s^2 at the start of the step, for any
// mass: v = a h, p = a h^2.
TEST(Bullet, WellsPullAsForces) {
  World world;
  world.settings.gravity.setZero();
  world.tracks = {{.keyframes = {{.position = {3, 20, 0}, .strength = 250}}, .softening = 4}};
  world.balls.add({.position = {0, 20, 0}}, 0.5, 7);
  run(world, 1);
  EXPECT_NEAR(world.balls.velocity[0].x(), 0.1, 1e-7);
  EXPECT_NEAR(world.balls.position[0].x(), 0.1 / 60, 1e-8);
}

TEST(Bullet, DragIsAFactorPerSecondOfTheVelocityAlone) {
  World world = oneBall({.position = {0, 20, 0}, .velocity = {2, 0, 0}, .spin = {0, 3, 0}});
  world.settings.gravity.setZero();
  world.settings.drag = 0.25;
  run(world, 30);
  EXPECT_NEAR(world.balls.velocity[0].x(), 2 * 0.5, 1e-5) << "0.25 to the power of 1/2";
  EXPECT_NEAR(world.balls.spin[0].y(), 3, 1e-6);
}

// It notices the ground at the end of a step, so it may be as deep as it moves in one: v h with
// v = sqrt(2 g 5 m).
TEST(Bullet, BouncesAboveTheGroundWithinAStepsTravel) {
  World world = oneBall({.position = {0, 5.5, 0}});
  world.settings.elasticity = 1;
  const double travel = std::sqrt(2 * 9.81 * 5) / 60;
  const auto stepper = makeBullet();
  double highest = 0;
  for (int i = 0; i < 600; ++i) {
    stepper->step(world);
    EXPECT_GT(world.balls.position[0].y(), 0.5 - travel);
    if (i > 120) highest = std::max(highest, world.balls.position[0].y());
  }
  EXPECT_GT(highest, 2) << "it keeps bouncing";
}

// The effective coefficients are e and mu whatever meets: sqrt(e) sqrt(e) = e.
TEST(Bullet, HeadOnImpactHasTheWorldsElasticity) {
  World world;
  world.settings.gravity.setZero();
  world.settings.elasticity = 0.5;
  world.balls.add({.position = {0, 5, 0}, .velocity = {3, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {1.2, 5, 0}}, 0.5, 1);
  run(world, 20);
  EXPECT_NEAR(world.balls.velocity[0].x(), 3 * 0.5 * (1 - 0.5), 1e-4);
  EXPECT_NEAR(world.balls.velocity[1].x(), 3 * 0.5 * (1 + 0.5), 1e-4);
}

TEST(Bullet, GroundHasTheWorldsElasticity) {
  World world = oneBall({.position = {0, 1, 0}, .velocity = {0, -3, 0}});
  world.settings.gravity.setZero();
  world.settings.elasticity = 0.5;
  run(world, 30);
  EXPECT_NEAR(world.balls.velocity[0].y(), 1.5, 1e-4);
}

// One ball straight at the middle of each of the 64 faces. 2 cm/s are for the normals, which Bullet
// finds iteratively.
TEST(Bullet, WallFacesInwardAllRoundWithTheWorldsElasticity) {
  World world;
  world.settings.gravity.setZero();
  world.settings.elasticity = 0.5;
  for (int i = 0; i < 64; ++i) {
    const SinCos angle = sinCosOfTurns(i / 64.0);
    const Vec3 outward{angle.cos, 0, angle.sin};
    world.balls.add({.position = Vec3(0, 9, 0) + outward * 39, .velocity = outward * 3}, 0.5, 1);
  }
  run(world, 30);
  for (std::size_t i = 0; i < 64; ++i) {
    const SinCos angle = sinCosOfTurns(static_cast<double>(i) / 64);
    EXPECT_LT(length(world.balls.velocity[i] + Vec3(angle.cos, 0, angle.sin) * 1.5), 0.02) << i;
  }
}

// Sliding: v = v0 - mu g t, while the spin grows by 5/2 mu g / r a second. 0.3 s are before it
// rolls, at 2 v0 / (7 mu g) = 0.49 s. Two steps' worth of mu g h for how it settles at first.
TEST(Bullet, SlidesWithTheWorldsFriction) {
  World world = oneBall({.position = {0, 0.5, 0}, .velocity = {5, 0, 0}});
  run(world, 18);
  const double slowed = 0.3 * 9.81 * 0.3;
  const double perStep = 0.3 * 9.81 / 60;
  EXPECT_NEAR(world.balls.velocity[0].x(), 5 - slowed, 2 * perStep);
  EXPECT_NEAR(world.balls.spin[0].z() * 0.5, -2.5 * slowed, 5 * perStep);
}

// v' = -5/7 b/r g = -1.4 m/s^2, as ours, in the first 0.1 s. Later its manifolds keep points that
// the ball has rolled off, which brake it a little more.
TEST(Bullet, RollsWithTheWorldsResistance) {
  World world = oneBall({.position = {0, 0.5, 0}, .velocity = {2, 0, 0}, .spin = {0, 0, -4}});
  world.settings.rollingResistance = 0.1;
  const double braking = 5.0 / 7 * 0.2 * 9.81;
  run(world, 6);
  EXPECT_NEAR(world.balls.velocity[0].x(), 2 - 0.1 * braking, 1e-4);
  run(world, 54);
  EXPECT_NEAR(world.balls.velocity[0].x(), 2 - braking, 0.1 * braking);
  run(world, 60);
  EXPECT_LE(length(world.balls.velocity[0]), 1e-3);
}

// Between two faces of the polygon a centre reaches out to (R - r) / cos(pi / 64). Start, well (S /
// softening = 75 m^2/s^2 deep) and gravity (4 m) give a ball 16 m/s; with 20 m/s it moves 0.33 m a
// step, which is what may be overlooked.
TEST(Bullet, WallAndGroundKeepACrowd) {
  World world;
  world.settings.elasticity = 1;
  world.arena = {.center = {1000, -500, 300}, .radius = 12};
  world.tracks = {{.keyframes = {{.position = {1006, -499, 300}, .strength = 150}}}};
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const int place = i % 100;
    const Vec3 at{1.5 * (place % 10) - 7, 1 + 1.5 * (i / 100), 1.5 * (place / 10) - 7};
    world.balls.add({.position = world.arena.center + at, .velocity = random.direction() * 5}, 0.5,
                    1);
  }
  const auto stepper = makeBullet();
  const double corner = (12 - 0.5) / std::cos(kPi / 64);
  for (int i = 0; i < 600; ++i) {
    stepper->step(world);
    for (const Vec3& position : world.balls.position) {
      const Vec3 place = position - world.arena.center;
      ASSERT_LT(std::hypot(place.x(), place.z()), corner + 0.33) << "step " << i;
      ASSERT_GT(place.y(), 0.5 - 0.33) << "step " << i;
    }
  }
  EXPECT_GT(stepper->counts().contacts, 0);
  EXPECT_GT(stepper->counts().candidatePairs, 0);
}

TEST(Bullet, TakesUpWhatWasChangedFromOutside) {
  World world;
  world.settings.gravity.setZero();
  world.balls.add({.position = {0, 5, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {5, 5, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  const auto stepper = makeBullet();
  run(*stepper, world, 60);
  world.balls.setState(0, {.position = {-3, 7, 2}, .velocity = {0, 0, 6}, .spin = {0, 2, 0}});
  run(*stepper, world, 1);
  EXPECT_LT(length(world.balls.position[0] - Vec3(-3, 7, 2.1)), 1e-6);
  EXPECT_LT(length(world.balls.velocity[0] - Vec3(0, 0, 6)), 1e-6);
  EXPECT_LT(length(world.balls.spin[0] - Vec3(0, 2, 0)), 1e-6);
  EXPECT_NEAR(world.balls.position[1].x(), 5 + 61.0 / 60, 5e-5);
}

TEST(Bullet, TakesUpChangedSettingsAndAddedBalls) {
  World world = oneBall({.position = {0, 20, 0}});
  const auto stepper = makeBullet();
  run(*stepper, world, 30);
  world.settings.gravity.setZero();
  run(*stepper, world, 30);
  EXPECT_NEAR(world.balls.velocity[0].y(), -9.81 / 2, 1e-5);
  world.balls.add({.position = {5, 20, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  run(*stepper, world, 60);
  EXPECT_NEAR(world.balls.velocity[0].y(), -9.81 / 2, 1e-5);
  EXPECT_NEAR(world.balls.position[1].x(), 6, 5e-5);
}

// A well is switched on after 5 s of rest: who sleeps does not feel it.
TEST(Bullet, SleepsOnlyWhereAskedTo) {
  for (const auto sleeping : {BulletSleeping::Off, BulletSleeping::On}) {
    World world = oneBall({.position = {0, 0.5, 0}});
    world.tracks = {{.keyframes = {{.step = 0, .position = {5, 0.5, 0}, .strength = 0},
                                   {.step = 300, .position = {5, 0.5, 0}, .strength = 100}}}};
    const auto stepper = makeBullet({.sleeping = sleeping});
    run(*stepper, world, 330);
    const double moved = world.balls.position[0].x();
    if (sleeping == BulletSleeping::On) {
      EXPECT_NEAR(moved, 0, 1e-6);
      world.settings.gravity.y() = -5;
      run(*stepper, world, 30);
      EXPECT_GT(world.balls.position[0].x(), 0.1) << "a change of settings wakes it";
    } else {
      EXPECT_GT(moved, 0.1);
    }
  }
}

TEST(Bullet, RepeatsItsBits) {
  World world;
  world.arena.radius = 10;
  world.tracks = {{.keyframes = {{.position = {5, 1, 0}, .strength = 100}}}};
  Random random(9);
  for (int i = 0; i < 200; ++i) {
    world.balls.add({.position = {1.2 * (i % 8) - 4, 1 + 1.2 * (i / 64), 1.2 * (i / 8 % 8) - 4},
                     .velocity = random.direction()},
                    0.5, 1);
  }
  World again = world;
  run(world, 300);
  run(again, 300);
  EXPECT_EQ(world.balls.position, again.balls.position);
  EXPECT_EQ(world.balls.velocity, again.balls.velocity);
  EXPECT_EQ(world.balls.spin, again.balls.spin);
}

}  // namespace
}  // namespace wells
