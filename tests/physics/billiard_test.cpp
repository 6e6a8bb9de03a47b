// Billiards without friction or gravity: between balls, and round inside the wall.
#include <gtest/gtest.h>

#include "scenes/catalogue.h"
#include "scenes/exact_answers.h"
#include "support/run_world.h"
#include "world/measures.h"

namespace wells {
namespace {

// The second impact magnifies the error of the first by about distance / diameter = 5, the way from
// there by 10: from 1e-15 to 1e-13 m.
TEST(Billiard, IsExactAtAnyStep) {
  for (const double rate : {6, 30, 60, 960}) {
    World world = makeScene(findScene("billiard"));
    world.settings.dt = 1 / rate;
    EXPECT_EQ(runFor(world, 3).impacts, 2) << rate;
    EXPECT_LE(positionError(findAccuracyCase("billiard"), world), 1e-9) << rate;
  }
}

// Elastic and smooth physics runs backwards: rounding is magnified there and back.
TEST(Billiard, RunsBackwards) {
  const World start = makeScene(findScene("billiard"));
  World world = start;
  runFor(world, 3);
  for (Vec3& v : world.balls.velocity) v = -v;
  runFor(world, 3);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LE(length(world.balls.position[i] - start.balls.position[i]), 1e-9) << i;
}

// From (0, 3) along x the chords are 3 m from the axis: hits at equal angles, 277 by t = 1000. The
// angle of each is rounded by 1e-16, which all later ones keep: 277^(3/2) 1e-16 times 10 m is
// 5e-12.
TEST(CircleBilliard, Has277Hits) {
  for (const double rate : {6, 60}) {
    World world = makeScene(findScene("circle-billiard"));
    world.settings.dt = 1 / rate;
    EXPECT_EQ(runFor(world, 1000).impacts, 277) << rate;
    EXPECT_LE(positionError(findAccuracyCase("circle-billiard"), world), 1e-7) << rate;
    EXPECT_NEAR(length(world.balls.velocity[0]), 5, 5e-12) << rate;
    EXPECT_NEAR(measure(world).angularMomentum.y(), 15, 1.5e-11) << rate;
  }
}

// The same path at 10^4 m/s, in five steps of 0.1 s with 55 hits each.
TEST(CircleBilliard, IsTheSameFilmAtAnySpeed) {
  World world = makeScene(findScene("circle-billiard"));
  world.balls.velocity[0] = {1e4, 0, 0};
  world.settings.dt = 0.1;
  EXPECT_EQ(run(world, 5).impacts, 277);
  EXPECT_LE(positionError(findAccuracyCase("circle-billiard"), world), 1e-7);
}

}  // namespace
}  // namespace wells
