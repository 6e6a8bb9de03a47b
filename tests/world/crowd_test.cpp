// What a large island in substeps does, seen from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "contacts/substep_rules.h"
#include "math/random.h"
#include "world/contact_choice.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr double kRadius = 0.5;  // m

/// Nothing pulls; all by substeps.
World emptySpace(double elasticity, double friction) {
  World world;
  world.settings.contactMethod = ContactMethod::Substep;
  world.settings.gravity = {0, 0, 0};
  world.settings.elasticity = elasticity;
  world.settings.friction = friction;
  world.settings.sleepSpeed = 0;
  return world;
}

/// One step, in which all balls are of one crowd.
void stepCrowd(World& world) {
  const auto simulation = makeSimulation();
  simulation->step(world);
  ASSERT_GT(world.balls.size(), kCrowd);
  ASSERT_EQ(simulation->counts().substepBalls, static_cast<std::int64_t>(world.balls.size()));
  ASSERT_EQ(simulation->counts().directContacts, 0);
}

/// A block of balls whose neighbours overlap a little, with velocities, spins and masses at random.
World block(double elasticity, double friction) {
  World world = emptySpace(elasticity, friction);
  Random random(8);
  for (int x = 0; x < 6; ++x)
    for (int y = 0; y < 5; ++y)
      for (int z = 0; z < 4; ++z)
        world.balls.add({.position = Vec3(0, 9, 0) + 2 * kRadius * 0.99 * Vec3(x, y, z),
                         .velocity = random.uniform(0, 2) * random.direction(),
                         .spin = random.uniform(0, 2) * random.direction()},
                        kRadius, random.uniform(0.5, 2));
  return world;
}

double kineticEnergy(const Balls& balls) {
  double sum = 0;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const double inertia = kInertiaFactor * balls.mass[i] * balls.radius[i] * balls.radius[i];
    sum += 0.5 * balls.mass[i] * squaredLength(balls.velocity[i]) +
           0.5 * inertia * squaredLength(balls.spin[i]);
  }
  return sum;
}

// A row of balls that fly side by side and never touch; the first is hit from behind, head-on:
// both have (1 +- e)/2 of the relative speed afterwards, and nobody else notices.
TEST(Crowd, MovesThoseThatMeetAlone) {
  constexpr double kElasticity = 0.6;
  World world = emptySpace(kElasticity, 0.3);
  world.arena.radius = 100;
  const double gap = 0.05;
  const Vec3 along(0, 0, 3);
  for (int i = 0; i < 80; ++i)
    world.balls.add({.position = {-40 + (2 * kRadius + gap) * i, 5, 0}, .velocity = along}, kRadius,
                    1 + i % 3);
  const double speed = 6;  // m/s, over gap within the step
  ASSERT_GT(speed * world.settings.dt, gap);
  world.balls.mass[0] = world.balls.mass[1] = 2;
  world.balls.velocity[0].x() = speed;
  const Balls start = world.balls;
  stepCrowd(world);
  const Balls& balls = world.balls;
  EXPECT_NEAR(balls.velocity[0].x(), speed * (1 - kElasticity) / 2, 1e-14);
  EXPECT_NEAR(balls.velocity[1].x(), speed * (1 + kElasticity) / 2, 1e-14);
  const Vec3 way = along * world.settings.dt;
  for (std::size_t i = 2; i < balls.size(); ++i) {
    EXPECT_EQ(balls.velocity[i], start.velocity[i]);
    EXPECT_EQ(balls.spin[i], start.spin[i]);
    EXPECT_LE(length(balls.position[i] - start.position[i] - way), 1e-14);
  }
}

// The last ball of a row hits one at rest, which hits another: these two would not come near each
// other if nothing deflected them, so nobody keeps them ready. Elastic and head-on, the last of all
// goes on with the speed of the first.
TEST(Crowd, SolvesContactsOfBallsThatHaveBeenDeflected) {
  World world = emptySpace(1, 0);
  world.arena.radius = 100;
  world.settings.substeps = 8;
  const auto add = [&](double x, double speed) {
    world.balls.add({.position = {x, 5, 0}, .velocity = {speed, 0, 0}}, kRadius, 1);
  };
  constexpr double kSpeed = 40;  // m/s
  constexpr int kRow = 80;
  for (int i = 0; i < kRow; ++i) add(1.05 * (i - kRow), i + 1 < kRow ? 0 : kSpeed);
  const double gap = 0.15 * 2 * kRadius;
  ASSERT_GT(gap, kFarGap * 2 * kRadius);
  add(0, 0);
  add(2 * kRadius + gap, 0);
  ASSERT_LT(0.05 + gap, kSpeed * world.settings.dt);
  stepCrowd(world);
  EXPECT_NEAR(world.balls.velocity[kRow - 1].x(), 0, 1e-10);
  EXPECT_NEAR(world.balls.velocity[kRow].x(), 0, 1e-10);
  EXPECT_NEAR(world.balls.velocity[kRow + 1].x(), kSpeed, 1e-10);
}

// Impulses and shifts between balls are equal and opposite.
TEST(Crowd, KeepsMomentumAndCentreOfMass) {
  for (const double elasticity : {0.0, 0.7})
    for (const double friction : {0.0, 0.4}) {
      World world = block(elasticity, friction);
      const auto sum = [&](const std::vector<Vec3>& of) {
        Vec3 total = Vec3::Zero();
        for (std::size_t i = 0; i < of.size(); ++i) total += world.balls.mass[i] * of[i];
        return total;
      };
      const Vec3 momentum = sum(world.balls.velocity);
      const Vec3 expected = sum(world.balls.position) + world.settings.dt * momentum;
      stepCrowd(world);
      EXPECT_LE(length(sum(world.balls.velocity) - momentum), 1e-12);
      EXPECT_LE(length(sum(world.balls.position) - expected), 1e-10);
    }
}

// Of all velocities in which no contact closes, inelastic impacts end nearest to those before, and
// each impulse on the way there takes energy; so does friction.
TEST(Crowd, LosesEnergyInInelasticImpacts) {
  for (const double friction : {0.0, 0.4}) {
    World world = block(0, friction);
    const double start = kineticEnergy(world.balls);
    stepCrowd(world);
    EXPECT_LT(kineticEnergy(world.balls), start);
  }
}

TEST(Crowd, PartsBallsThatOverlap) {
  World world = block(0, 0);
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    world.balls.setState(i, {.position = world.balls.position[i]});
  const auto deepest = [&] {
    const Balls& balls = world.balls;
    double depth = 0;
    for (std::size_t a = 0; a < balls.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        depth = std::max(depth, 2 * kRadius - length(balls.position[a] - balls.position[b]));
    return depth;
  };
  const double start = deepest();
  const auto simulation = makeSimulation();
  for (int step = 0; step < 30; ++step) simulation->step(world);
  EXPECT_GT(start, 0.009);
  EXPECT_LT(deepest(), 0.1 * start);  // at most 1e-3 of a radius may be left
  for (const Vec3& velocity : world.balls.velocity) EXPECT_EQ(length(velocity), 0);
}

}  // namespace
}  // namespace wells
