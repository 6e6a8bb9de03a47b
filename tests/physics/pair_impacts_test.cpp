// Impacts of two balls, with and without friction, against closed forms and the reference.
#include <gtest/gtest.h>

#include <cmath>

#include "math/random.h"
#include "scenes/catalogue.h"
#include "scenes/unit_balls.h"
#include "support/oracle_world.h"
#include "support/run_world.h"

namespace wells {
namespace {

World afterTwoSeconds(const char* scene) {
  World world = makeScene(findScene(scene));
  EXPECT_EQ(run(world, 120).impacts, 1) << scene;
  return world;
}

// At the impact the centres are 0.4 m off the line of flight: n = (sqrt(0.84), 0, 0.4), and B takes
// (v . n) n = (4.2, 0, 2 sqrt(0.84)). 1e-12 relative to 5 m/s: rounding alone.
TEST(PairImpact, ObliqueAndSmooth) {
  const World world = afterTwoSeconds("oblique-balls");
  EXPECT_LE(length(world.balls.velocity[0] - Vec3(0.8, 0, -1.833030277982336)), 5e-12);
  EXPECT_LE(length(world.balls.velocity[1] - Vec3(4.2, 0, 1.833030277982336)), 5e-12);
}

// n = (cos 30, 0, sin 30), v_n = 5 cos 30, u_t = 5 sin 30, m* = 1/2: J_n = (1 + e) m* v_n = 3.897,
// and J_t = 2/7 m* u_t = 5/14 < mu J_n sticks: with t = (sin 30, 0, -cos 30)
//   v_A = (5, 0, 0) - J_n n - J_t t,   v_B = J_n n + J_t t,   w = 5/2 (n x -J_t t) / (m r) each.
TEST(PairImpact, FrictionSticks) {
  const World world = afterTwoSeconds("friction-balls-stick");
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const double normal = 1.8 * 0.5 * 5 * c, tangent = 5.0 / 14;
  const Vec3 b = normal * Vec3(c, 0, s) + tangent * Vec3(s, 0, -c);
  EXPECT_LE(length(world.balls.velocity[0] - (Vec3(5, 0, 0) - b)), 5e-12);
  EXPECT_LE(length(world.balls.velocity[1] - b), 5e-12);
  for (const Vec3& spin : world.balls.spin)
    EXPECT_LE(length(spin - Vec3(0, -2.5 * tangent / 0.5, 0)), 5e-12);
}

// Head-on, A spins about z: u_t = r w = 10 upward at the contact, J_n = 1.8 * 2.5 = 4.5, and mu J_n
// = 1.35 < 2/7 m* u_t = 10/7 slips: A is thrown down, B up, both lose 5/2 * 1.35 / 0.5 rad/s.
TEST(PairImpact, FrictionSlips) {
  const World world = afterTwoSeconds("friction-balls-slip");
  EXPECT_LE(length(world.balls.velocity[0] - Vec3(0.5, -1.35, 0)), 5e-12);
  EXPECT_LE(length(world.balls.velocity[1] - Vec3(4.5, 1.35, 0)), 5e-12);
  EXPECT_LE(length(world.balls.spin[0] - Vec3(0, 0, 13.25)), 2e-11);
  EXPECT_LE(length(world.balls.spin[1] - Vec3(0, 0, -6.75)), 2e-11);
}

// Two balls of any radii, masses, spins, e and mu.
TEST(PairImpact, OfAnyTwoBalls) {
  Random random(5);
  int hits = 0;
  for (int seed = 0; seed < 200; ++seed) {
    World world = makeScene(findScene("oblique-balls"));
    world.settings.elasticity = random.uniform();
    world.settings.friction = random.uniform();
    Balls& b = world.balls;
    for (std::size_t i = 0; i < 2; ++i) {
      b.radius[i] = random.uniform(0.2, 1.5);
      b.mass[i] = std::exp(random.uniform(-3, 3));
      b.spin[i] = random.uniform(0, 30) * random.direction();
    }
    b.position[0] = {-3, 20, 0};
    b.position[1] =
        b.position[0] + 4 * Vec3(1, random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2));
    b.velocity[0] = {6, 0, 0};
    b.velocity[1] = random.direction();
    std::vector<oracle::Body> bodies = oracle::bodiesOf(world);
    const oracle::Hits expected = oracle::fly(oracle::rulesOf(world), bodies, 1);
    EXPECT_EQ(run(world, 60).impacts, expected.count) << seed;
    hits += static_cast<int>(expected.count);
    for (std::size_t i = 0; i < 2; ++i) {
      // Speeds up to 6 m/s, surface speeds up to 45 m/s; a light ball takes up to twice that.
      EXPECT_LE(length(b.velocity[i] - oracle::vectorOf(bodies[i].v)), 1e-11) << seed;
      EXPECT_LE(length(b.spin[i] - oracle::vectorOf(bodies[i].w)), 1e-10) << seed;
      EXPECT_LE(length(b.position[i] - oracle::vectorOf(bodies[i].x)), 1e-11) << seed;
    }
  }
  EXPECT_GT(hits, 150);
}

// A ball falls onto one that rests on the ground, beside its top. What rests is driven into the
// ground at the same instant and comes back from it: first the pair, then the ground, and on from
// there.
TEST(PairImpact, FallsOntoABallThatRests) {
  for (const double friction : {0.0, 0.3})
    for (const double aside : {0.1, 0.3, -0.6}) {
      World world;
      world.settings.elasticity = 1;
      world.settings.friction = friction;
      addUnitBall(world, {aside, 4, 0});
      addUnitBall(world, {0, 0.5, 0});
      std::vector<oracle::Body> bodies = oracle::bodiesOf(world);
      const oracle::Rules rules = oracle::rulesOf(world);
      oracle::Body& a = bodies[0];
      // They meet when A is sqrt(1 - aside^2) above B.
      const oracle::Real height = std::sqrt(1 - a.x.x * a.x.x);
      const oracle::Real time = std::sqrt(2 * (3.5L - height) / rules.gravity);
      a.x.y = 0.5L + height;
      a.v.y = -rules.gravity * time;
      oracle::detail::hit(rules, bodies[1].x - a.x, a, &bodies[1]);
      oracle::detail::hit(rules, {0, -1, 0}, bodies[1], nullptr);
      oracle::fly(rules, bodies, 1.0L - time);
      run(world, 60);
      for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_LE(length(world.balls.position[i] - oracle::vectorOf(bodies[i].x)), 1e-11) << aside;
        EXPECT_LE(length(world.balls.spin[i] - oracle::vectorOf(bodies[i].w)), 1e-10) << aside;
      }
    }
}

}  // namespace
}  // namespace wells
