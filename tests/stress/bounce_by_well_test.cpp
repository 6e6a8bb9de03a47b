// Balls that bounce to rest beside a well so sharp that flight is divided: the shortest bounces
// fall on the borders of its stretches.
#include <gtest/gtest.h>

#include <algorithm>

#include "math/random.h"
#include "world/simulation.h"

namespace wells {
namespace {

// Exact impacts leave no overlap but rounding: 1e-9 m is ten times what positions of some metres
// collect over the impacts of a step.
TEST(BounceByWell, NobodyFallsThroughTheGround) {
  Random random(3);
  int below = 0;
  double deepest = 0;
  for (int drop = 0; drop < 200; ++drop) {
    World world;
    world.settings.elasticity = 0.5;
    world.tracks = {{.keyframes = {{0, Vec3{5, 1, 0}, 112}}, .softening = 0.5}};
    world.balls.add(
        {.position = {0, random.uniform(0.51, 2.5), 0}, .velocity = {random.uniform(-1, 1), 0, 0}},
        0.5, 1);
    const auto stepper = makeSimulation();
    for (int step = 0; step < 180; ++step) {
      stepper->step(world);
      ASSERT_GT(stepper->counts().flightStretches, 1);
      const double depth = 0.5 - world.balls.position[0].y();
      if (stepper->counts().substepBalls > 0 || depth <= 1e-9) continue;
      ++below;
      deepest = std::max(deepest, depth);
    }
  }
  EXPECT_EQ(below, 0) << "steps by exact impacts that end below the ground, by up to " << deepest
                      << " m";
}

}  // namespace
}  // namespace wells
