// Cases of one ball above the ground: elastic bounces, and bounces that die away.
//
// With h = 5 m, t1 = sqrt(2 h / g) and the impacts at speed u = sqrt(2 g h), u e, u e^2, ...
#include <gtest/gtest.h>

#include <cmath>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "support/oracle_world.h"
#include "support/run_world.h"
#include "support/transformed_world.h"
#include "world/measures.h"

namespace wells {
namespace {

constexpr double kStepRates[] = {6, 30, 60, 960};  // Hz

World bounceAt(const char* scene, double rate) {
  World world = makeScene(findScene(scene));
  world.settings.dt = 1 / rate;
  return world;
}

/// Height (m) of the ball at `time`, by the reference.
double heightAt(const World& start, double time) {
  std::vector<oracle::Body> bodies = oracle::bodiesOf(start);
  oracle::fly(oracle::rulesOf(start), bodies, time);
  return static_cast<double>(bodies[0].x.y);
}

// Period 2 t1: five hits by t = 10. Rounding alone: 1e-9 m and 1e-12 leave it four digits.
TEST(ElasticBounce, IsExactAtAnyStep) {
  for (const double rate : kStepRates) {
    World world = bounceAt("bounce", rate);
    const double energy = measure(world).energy();
    EXPECT_EQ(runFor(world, 10).impacts, 5) << rate;
    EXPECT_LE(positionError(findAccuracyCase("bounce"), world), 1e-9) << rate;
    EXPECT_NEAR(measure(world).energy() / energy, 1, 1e-12) << rate;
  }
}

// A hundred thousand bounces, each of which rounds by up to an ulp, 2.2e-16.
TEST(ElasticBounce, KeepsItsEnergyForLong) {
  World world = bounceAt("bounce", 6);
  const double energy = measure(world).energy();
  const std::int64_t impacts = run(world, 1'200'000).impacts;
  EXPECT_NEAR(static_cast<double>(impacts), 2e5 / 2.019275109384609, 1);
  EXPECT_NEAR(measure(world).energy() / energy, 1, 2.2e-16 * static_cast<double>(impacts));
}

// While it bounces: 5, 13 and 21 impacts on. One impact's speed and time are rounded, and the
// flights get shorter: nothing is magnified.
TEST(Zeno, IsExactWhileItBounces) {
  for (const double rate : kStepRates)
    for (const double time : {6.0, 8.5, 9.0}) {
      const World start = bounceAt("zeno", rate);
      World world = start;
      runFor(world, time);
      EXPECT_NEAR(world.balls.position[0].y(), heightAt(start, time), 1e-9) << rate << " " << time;
    }
}

// To the last: a tenth of a millisecond before the rest, within the last of 54 steps, the flights
// last 20 microseconds. Times are rounded to 1e-15 s a flight, some 70 of them, which at g counts
// nothing.
TEST(Zeno, IsExactToTheLast) {
  World start = bounceAt("zeno", 54 / (9.08673799223074 - 1e-4));
  std::vector<oracle::Body> bodies = oracle::bodiesOf(start);
  World world = start;
  run(world, 54);
  oracle::fly(oracle::rulesOf(start), bodies, world.time());
  EXPECT_GT(std::abs(bodies[0].v.y), 1e-6L);
  EXPECT_NEAR(world.balls.velocity[0].y(), static_cast<double>(bodies[0].v.y), 1e-9);
  EXPECT_NEAR(world.balls.position[0].y(), static_cast<double>(bodies[0].x.y), 1e-12);
}

// At rest sqrt(2 h / g) (1 + e) / (1 - e) after the release, which is 9.08673799223074 s for e = .8
// and 3.028912664076913 s for e = .5. Until one step before it moves; after one step it rests.
TEST(Zeno, RestsAtTheRightTime) {
  for (const auto& [scene, rest] :
       {std::pair{"zeno", 9.08673799223074}, {"zeno-rest", 3.028912664076913}})
    for (const double rate : {30.0, 60.0, 960.0, 20'000.0}) {
      World world = bounceAt(scene, rate);
      const auto before = static_cast<std::int64_t>(std::floor(rest * rate)) - 1;
      run(world, before);
      // A flight of length s has speed g s / 2 at most; the last one resolved is far below a step.
      EXPECT_GT(std::abs(world.balls.velocity[0].y()) + world.balls.position[0].y() - 0.5, 1e-7)
          << scene << " " << rate;
      run(world, 3);
      EXPECT_EQ(world.balls.velocity[0].y(), 0) << scene << " " << rate;
      EXPECT_NEAR(world.balls.position[0].y(), 0.5, 1e-12) << scene << " " << rate;
    }
}

// Then it neither sinks nor creeps.
TEST(Zeno, RestsForAMillionSteps) {
  World world = bounceAt("zeno", 60);
  runFor(world, 10);
  const auto simulation = makeSimulation();
  double worst = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    simulation->step(world);
    worst = std::max(worst, std::abs(world.balls.position[0].y() - 0.5));
  }
  EXPECT_LE(worst, 1e-9);
  EXPECT_LE(std::hypot(world.balls.position[0].x(), world.balls.position[0].z()), 1e-9);
}

// Nor anywhere else, where the ground's height is no round number.
TEST(Zeno, RestsAnywhere) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Transform seen = randomTransform(seed, 1, 1000);
    World world = seen.apply(makeScene(findScene("zeno-rest")));
    run(world, 20'000);
    EXPECT_LE(length(seen.undo(world).position[0] - Vec3(0, 0.5, 0)), 1e-9) << seed;
  }
}

}  // namespace
}  // namespace wells
