// Small crowds of balls of all sizes with gravity, ground, wall, restitution and friction, against
// the event-driven reference: every impact at its time and with its spin, whatever the step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "math/random.h"
#include "scenes/unit_balls.h"
#include "support/oracle_world.h"
#include "support/run_world.h"

namespace wells {
namespace {

/// Balls on a lattice of 2.2 m that fly about in a narrow arena.
World crowd(std::uint64_t seed) {
  Random random(seed);
  World world;
  world.arena.radius = 4;
  world.settings.dt = seed % 2 == 0 ? 1.0 / 60 : 1.0 / 12;
  world.settings.gravity = seed % 3 == 0 ? Vec3::Zero() : Vec3(0, -9.81, 0);
  world.settings.elasticity = seed % 4 == 0 ? 1 : random.uniform(0.6, 1);
  world.settings.friction = seed % 5 == 0 ? 0 : random.uniform(0, 0.6);
  for (int i = -1; i <= 1; ++i)
    for (int k = 0; k < 2; ++k)
      for (int j = -1; j <= 1; j += 2)
        world.balls.add({.position = {2.2 * i, 4 + 2.2 * k, 1.1 * j},
                         .velocity = random.uniform(0, 8) * random.direction(),
                         .spin = random.uniform(0, 20) * random.direction()},
                        random.uniform(0.2, 1), std::exp(random.uniform(-1.5, 1.5)));
  return world;
}

double distance(const std::vector<oracle::Body>& a, const std::vector<oracle::Body>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max(worst, static_cast<double>(oracle::size(a[i].x - b[i].x)));
  return worst;
}

// Impacts of balls magnify errors about tenfold each. By how much in all is seen from a second run
// of the reference that starts 1e-10 m off: rounding, 1e-15 m an impact, is magnified no more.
TEST(RandomImpacts, FollowTheReference) {
  std::int64_t compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    World world = crowd(seed);
    std::vector<oracle::Body> bodies = oracle::bodiesOf(world), off = bodies;
    Random random(seed);
    for (oracle::Body& body : off) body.x = body.x + 1e-10L * oracle::pointOf(random.direction());
    const oracle::Rules rules = oracle::rulesOf(world);
    const oracle::Hits hits = oracle::fly(rules, bodies, 1);
    oracle::fly(rules, off, 1);
    const double magnified = std::max(1.0, distance(bodies, off) / 1e-10);
    if (magnified > 1e7) continue;  // chaos: nothing to compare

    const RunCounts counts = run(world, std::llround(1 / world.settings.dt));
    EXPECT_EQ(counts.impacts, hits.count) << seed;
    EXPECT_EQ(counts.latePairs, 0) << seed;
    compared += hits.count;
    // Lengths up to 10 m, an ulp of which is 1e-15; speeds and spins per metre up to 100 / s.
    const double allowed = 1e-13 * magnified;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      EXPECT_LE(length(world.balls.position[i] - oracle::vectorOf(bodies[i].x)), allowed) << seed;
      EXPECT_LE(length(world.balls.velocity[i] - oracle::vectorOf(bodies[i].v)), 100 * allowed)
          << seed;
      EXPECT_LE(length(world.balls.spin[i] - oracle::vectorOf(bodies[i].w)), 1000 * allowed)
          << seed;
    }
  }
  EXPECT_GT(compared, 500);
}

// A ball at rest is thrown 4 m within the step, further than it could be expected to move, against
// another one at rest; what hits that one from beyond throws all of them back to where they began.
TEST(RandomImpacts, ReachBeyondWhatWasForeseenAndBack) {
  World world = freeWorld();
  world.settings.dt = 1;
  addUnitBall(world, {-6, 1, 0}, {40, 0, 0});
  addUnitBall(world, {0, 1, 0});
  addUnitBall(world, {5, 1, 0});
  addUnitBall(world, {25, 1, 0}, {-40, 0, 0});
  std::vector<oracle::Body> bodies = oracle::bodiesOf(world);
  EXPECT_EQ(oracle::fly(oracle::rulesOf(world), bodies, 1).count, 5);
  EXPECT_EQ(run(world, 1).impacts, 5);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LE(length(world.balls.position[i] - oracle::vectorOf(bodies[i].x)), 1e-12) << i;
}

}  // namespace
}  // namespace wells
