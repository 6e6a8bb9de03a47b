// What physics keeps: momentum, angular momentum, energy, symmetry and the way back.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "math/random.h"
#include "scenes/catalogue.h"
#include "scenes/unit_balls.h"
#include "support/run_world.h"
#include "support/transformed_world.h"
#include "world/exact_flight.h"
#include "world/measures.h"

namespace wells {
namespace {

/// Sum of m |v|: what rounding of the momentum is relative to.
double momentumSize(const World& world) {
  double sum = 0;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    sum += world.balls.mass[i] * length(world.balls.velocity[i]);
  return sum;
}

/// Balls that fly towards each other in the middle of a large arena, far above the ground.
World cloud(std::uint64_t seed) {
  Random random(seed);
  World world = freeWorld();
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j)
      for (int k = -3; k <= 3; ++k) {
        const Vec3 place{1.5 * i, 1.5 * j, 1.5 * k};
        world.balls.add({.position = Vec3(0, 20, 0) + place,
                         .velocity = random.direction() - 0.5 * place,
                         .spin = 5 * random.direction()},
                        random.uniform(0.3, 0.7), random.uniform(0.5, 2));
      }
  return world;
}

// Balls alone: each impact gives and takes the same, at the same point. 1e-12 of the sum of m |v|,
// of m |v| |x| and of the spins.
TEST(Conservation, OfMomentumAmongBalls) {
  for (const double friction : {0.0, 0.4})
    for (const double elasticity : {1.0, 0.7}) {
      World world = cloud(1);
      world.settings.contactMethod = ContactMethod::Exact;  // by default such a crowd is not
      world.settings.friction = friction;
      world.settings.elasticity = elasticity;
      const Measures start = measure(world);
      EXPECT_GT(run(world, 60).impacts, 300);
      const Measures end = measure(world);
      EXPECT_LE(length(end.momentum - start.momentum), 1e-12 * momentumSize(world));
      EXPECT_LE(length(end.angularMomentum - start.angularMomentum),
                1e-12 * 25 * momentumSize(world));
      if (elasticity == 1 && friction == 0) {
        EXPECT_NEAR(end.kineticEnergy / start.kineticEnergy, 1, 1e-12);
      } else {
        EXPECT_LT(end.kineticEnergy, start.kineticEnergy);
      }
    }
}

// A fixed well pulls towards its centre, and so do all kicks of a symplectic integrator: angular
// momentum about it is kept to rounding, at any step.
TEST(Conservation, OfAngularMomentumAboutAWell) {
  for (const double rate : {6, 60})
    for (const char* integrator : {"pefrl", "leapfrog"}) {
      World world = makeScene(findScene("orbit"));
      world.settings.integrator = integrator;
      world.settings.dt = 1 / rate;
      world.balls.velocity[0] = {1, 2, 6};
      const Vec3 center = world.tracks[0].keyframes[0].position;
      const auto momentum = [&] {
        return cross(world.balls.position[0] - center, world.balls.velocity[0]);
      };
      const Vec3 before = momentum();
      runFor(world, 20);
      EXPECT_LE(length(momentum() - before), 1e-12 * length(before)) << integrator << " " << rate;
    }
}

// Smooth ground and wall and wells on the axis have no torque about it.
TEST(Conservation, OfAngularMomentumAboutTheAxis) {
  Random random(2);
  World world;
  world.settings.friction = 0;
  world.settings.elasticity = 1;
  world.arena.radius = 12;
  world.tracks = {{.keyframes = {{0, {0, 3, 0}, 40}}, .softening = 2}};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j) addUnitBall(world, {3.0 * i, 4, 3.0 * j}, 4 * random.direction());
  const double before = measure(world).angularMomentum.y();
  EXPECT_GT(run(world, 120).impacts, 30);
  EXPECT_NEAR(measure(world).angularMomentum.y(), before, 1e-12 * 12 * momentumSize(world));
}

// Gravity alone is exact, elastic impacts keep the energy: 1e-12 relative.
TEST(Conservation, OfEnergyUnderGravity) {
  World world = cloud(3);
  world.settings.gravity = {0, -9.81, 0};
  const double before = measure(world).energy();
  EXPECT_GT(run(world, 120).impacts, 400);
  EXPECT_NEAR(measure(world).energy() / before, 1, 1e-12);
  EXPECT_LE(measure(world).worstOverlap(), 1e-9);
}

// However long the step, elastic impacts are exact: in 0.2 s a ball of this gas is hit 0.9 times,
// and hundreds are thrown further than could be expected of their speed at the start.
TEST(Gas, KeepsItsEnergyInLongSteps) {
  World world = makeScene(findScene("T2"));
  world.settings.dt = 0.2;
  const double before = measure(world).kineticEnergy;
  const RunCounts counts = run(world, 10);
  EXPECT_GT(counts.impacts, 5000);
  EXPECT_EQ(counts.substepBalls, 0);
  EXPECT_NEAR(measure(world).kineticEnergy / before, 1, 1e-12);
  EXPECT_LE(measure(world).worstOverlap(), 1e-9);
}

// Nearly all balls of a dense gas may meet in one step, and so are one island; it has more impacts
// than one of few balls may have.
TEST(Gas, IsExactInOneIsland) {
  World world = makeScene(findScene("T2"));
  world.settings.contactMethod = ContactMethod::Exact;
  world.settings.elasticity = 0.9;
  world.settings.dt = 0.2;
  const RunCounts counts = run(world, 1);
  EXPECT_GT(counts.impacts, kMostInelasticImpacts);
  EXPECT_EQ(counts.substepBalls, 0);
}

// T2, for 5 s. In an elastic gas without forces the kinetic energy is that of the start and nothing
// overlaps; the momentum is what ground and wall gave, and a smooth wall gives no angular momentum
// about its axis.
TEST(Gas, KeepsWhatItHasAndBooksTheRest) {
  World world = makeScene(findScene("T2"), 10'000);
  const Measures start = measure(world);
  const auto simulation = makeSimulation();
  ASSERT_TRUE(simulation->openBooks());
  std::int64_t impacts = 0;
  for (int i = 0; i < 300; ++i) {
    simulation->step(world);
    impacts += simulation->counts().impacts;
    ASSERT_EQ(simulation->counts().substepBalls, 0);
    ASSERT_EQ(simulation->counts().latePairs, 0);
  }
  const Measures end = measure(world);
  const Books& books = *simulation->books();
  const double size = momentumSize(world);
  EXPECT_GT(impacts, 3000);
  EXPECT_NEAR(end.kineticEnergy / start.kineticEnergy, 1, 1e-12);
  EXPECT_LE(end.worstOverlap(), 1e-9);
  EXPECT_EQ(end.escaped, 0);
  const Vec3 given = books.ground.linear + books.wall.linear;
  EXPECT_GT(length(given), 1);
  EXPECT_LE(length(end.momentum - start.momentum - given), 1e-12 * size);
  EXPECT_NEAR(end.angularMomentum.y(), start.angularMomentum.y(), 1e-12 * 80 * size);
  EXPECT_LE(length(end.angularMomentum - start.angularMomentum - books.ground.angular -
                   books.wall.angular),
            1e-12 * 80 * size);
}

// Back to the start after 1 s there and 1 s back. An impact magnifies 1e-15 about tenfold, and a
// ball has 3 of them a second. (The same bits would need arithmetic that does not round: positions
// and times as integers, and impacts whose inverse is exact.)
TEST(Gas, RunsBackwards) {
  World world = makeScene(findScene("T2"), 1000);
  const World start = world;
  run(world, 60);
  for (Vec3& v : world.balls.velocity) v = -v;
  run(world, 60);
  double worst = 0;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    worst = std::max(worst, length(world.balls.position[i] - start.balls.position[i]));
  EXPECT_LE(worst, 1e-6);
}

/// A cue ball before a triangle of five rows of touching balls; ids from the cue on, row by row.
World triangle() {
  World world = freeWorld();
  addUnitBall(world, {-5, 1, 0}, {8, 0, 0});
  for (int row = 0; row < 5; ++row)
    for (int k = 0; k <= row; ++k) addUnitBall(world, {row * std::sqrt(3.0) / 2, 1, k - row / 2.0});
  return world;
}

// All touch when the cue ball hits the tip; the picture stays its own mirror image, whatever the
// ids and turns: 1e-12 of the cue ball's 8 m/s.
TEST(SymmetricBreak, StaysSymmetric) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const World plain = triangle();
    const Transform seen = seed < 20 ? exactTransform(seed, plain.balls.size())
                                     : randomTransform(seed, plain.balls.size(), 0);
    World world = seen.apply(plain);
    run(world, 90);
    EXPECT_NEAR(measure(world).kineticEnergy, 32, 32e-12) << seed;
    const Balls end = seen.undo(world);
    for (std::size_t row = 0, first = 1; row < 5; ++row, first += row)
      for (std::size_t k = 0; k <= row; ++k) {
        const Vec3& a = end.velocity[first + k];
        const Vec3& b = end.velocity[first + row - k];
        EXPECT_LE(length(a - Vec3(b.x(), b.y(), -b.z())), 8e-12) << seed << " row " << row;
      }
  }
}

}  // namespace
}  // namespace wells
