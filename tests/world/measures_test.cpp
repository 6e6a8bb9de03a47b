#include "world/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/random.h"

namespace wells {
namespace {

World emptyWorld() {
  World world;
  world.arena = {.center = {0, 0, 0}, .radius = 10};
  return world;
}

// One ball, by hand: m = 2, v = (3, 4, 0), w = (0, 0, 5), r = 0.5, at (1, 2, 0).
TEST(Measures, OneBallByHand) {
  World world = emptyWorld();
  world.balls.add({.position = {1, 2, 0}, .velocity = {3, 4, 0}, .spin = {0, 0, 5}}, 0.5, 2);
  world.tracks = {{.keyframes = {{0, {1, 2, 4}, 60}}, .softening = 3}};
  const Measures m = measure(world);
  const double inertia = 0.4 * 2 * 0.25;
  EXPECT_NEAR(m.kineticEnergy, 0.5 * 2 * 25 + 0.5 * inertia * 25, 1e-14);
  EXPECT_NEAR(m.potentialEnergy, 2 * 9.81 * 2 - 2 * 60 / 5.0, 1e-13);
  EXPECT_EQ(m.momentum, Vec3(6, 8, 0));
  // x p_y - y p_x = 1 * 8 - 2 * 6, plus the spin's.
  EXPECT_NEAR(m.angularMomentum.z(), -4 + inertia * 5, 1e-14);
  EXPECT_EQ(m.worstOverlap(), 0);
  EXPECT_EQ(m.escaped, 0);
}

TEST(Measures, OverlapsWithGroundAndWall) {
  World world = emptyWorld();
  world.balls.add({.position = {0, 0.3, 0}}, 0.5, 1);
  world.balls.add({.position = {0, 1, -9.9}}, 0.5, 1);
  const Measures m = measure(world);
  EXPECT_NEAR(m.groundOverlap, 0.2, 1e-15);
  EXPECT_NEAR(m.wallOverlap, 0.4, 1e-14);
  EXPECT_EQ(m.groundContacts, 1);
  EXPECT_EQ(m.wallContacts, 1);
  EXPECT_EQ(m.ballOverlap, 0);
  EXPECT_NEAR(m.squaredOverlaps, 0.2 * 0.2 + 0.4 * 0.4, 1e-14);
  EXPECT_EQ(m.escaped, 0);
}

TEST(Measures, EscapedBallsAndBallsThatAreNotFinite) {
  World world = emptyWorld();
  world.balls.add({.position = {0, -0.1, 0}}, 0.5, 1);
  world.balls.add({.position = {10.1, 5, 0}}, 0.5, 1);
  world.balls.add({.position = {0, 5, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  world.balls.add({.position = {0, std::nan(""), 0}}, 0.5, 1);
  world.balls.add(
      {.position = {0, 5, 0}, .velocity = {std::numeric_limits<double>::infinity(), 0, 0}}, 0.5, 1);
  const Measures m = measure(world);
  EXPECT_EQ(m.escaped, 4);
  EXPECT_EQ(m.momentum, Vec3(1, 0, 0));
}

TEST(Measures, BallOverlapsEqualBruteForce) {
  World world = emptyWorld();
  Random random(1);
  for (int i = 0; i < 400; ++i)
    world.balls.add(
        {.position = {random.uniform(-5, 5), random.uniform(1, 6), random.uniform(-5, 5)}},
        random.uniform(0.05, 0.6), 1);
  const Balls& b = world.balls;
  double worst = 0;
  double squares = 0;
  std::int64_t contacts = 0;
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = i + 1; j < b.size(); ++j) {
      const double overlap = b.radius[i] + b.radius[j] - (b.position[i] - b.position[j]).norm();
      worst = std::max(worst, overlap);
      contacts += overlap > 0;
      if (overlap > 0) squares += overlap * overlap;
    }
  ASSERT_GT(contacts, 50);
  EXPECT_EQ(measure(world).ballContacts, contacts);
  EXPECT_NEAR(measure(world).ballOverlap, worst, 1e-15);
  EXPECT_NEAR(measure(world).squaredOverlaps, squares, 1e-12);
}

TEST(StateHash, DependsOnEveryBit) {
  World world = emptyWorld();
  world.balls.add({.position = {1, 2, 3}, .velocity = {4, 5, 6}, .spin = {7, 8, 9}}, 0.5, 1);
  world.balls.add({.position = {3, 2, 1}}, 0.5, 1);
  const std::uint64_t hash = stateHash(world);
  EXPECT_EQ(hash, stateHash(world));
  World other = world;
  other.balls.position[1].z() = std::nextafter(1.0, 2.0);
  EXPECT_NE(hash, stateHash(other));
  other = world;
  other.balls.spin[0].y() = std::nextafter(8.0, 9.0);
  EXPECT_NE(hash, stateHash(other));
  other = world;
  other.step = 1;
  EXPECT_NE(hash, stateHash(other));
  other = world;
  std::swap(other.balls.position[0], other.balls.position[1]);
  EXPECT_NE(hash, stateHash(other));
  EXPECT_EQ(hashText(0xab), "00000000000000ab");
}

}  // namespace
}  // namespace wells
