// A ball that ground and wall hold at once, against closed forms and an independent path.
#include <gtest/gtest.h>

#include "scenes/unit_balls.h"
#include "support/order.h"
#include "support/step_errors.h"

namespace wells {
namespace {

constexpr double kArena = 10;            // m
constexpr double kRound = kArena - 0.5;  // m, from the axis to the centre of a ball at the wall

World cornerWorld(double friction, const Vec3& velocity, const Vec3& spin = Vec3::Zero()) {
  World world;
  world.arena.radius = kArena;
  world.settings.friction = friction;
  addUnitBall(world, {kRound, 0.5, 0}, velocity, spin);
  return world;
}

/// On the circle, after `way` (m) along -z.
Vec3 placeAfter(double way) {
  return {kRound * std::cos(way / kRound), 0.5, -kRound * std::sin(way / kRound)};
}

TEST(CornerPath, SmoothGoesRound) {
  World world = cornerWorld(0, {0, 0, -5}, {1, 2, 3});
  EXPECT_EQ(runFor(world, 10).substepBalls, 0);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(50)), 1e-12);
  EXPECT_EQ(world.balls.spin[0], Vec3(1, 2, 3));
}

// Rolling on both, it turns about an axis halfway between their normals: spin (-1, -1) v / r along
// (outward, up), and keeps its speed.
TEST(CornerPath, RollsOnBoth) {
  World world = cornerWorld(0.5, {0, 0, -5}, {-10, -10, 0});
  EXPECT_EQ(runFor(world, 10).substepBalls, 0);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(50)), 1e-12);
  EXPECT_NEAR(length(world.balls.velocity[0]), 5, 1e-12);
}

// Rolling on the ground, sliding along the wall: v' = -mu v^2 / rho, until v = 7/9 v0.
TEST(CornerPath, SlidingBecomesRollingOnBoth) {
  World world = cornerWorld(0.3, {0, 0, -5}, {-10, 0, 0});
  const RunCounts counts = runFor(world, 10);
  EXPECT_EQ(counts.substepBalls, 0);
  const double t1 = 2.0 / 7 * kRound / (0.3 * 5);
  const double way = kRound / 0.3 * std::log(9.0 / 7) + 35.0 / 9 * (10 - t1);
  EXPECT_LE(length(world.balls.position[0] - placeAfter(way)), 1e-8);
  EXPECT_NEAR(length(world.balls.velocity[0]), 35.0 / 9, 1e-9);
}

}  // namespace
}  // namespace wells
