// Contacts against geometry by hand, and the manifold against a test of all pairs.
#include "reference/detection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "math/random.h"

namespace wells {
namespace {

World emptyWorld() {
  World world;
  world.settings.gravity = {0, -10, 0};
  world.settings.friction = 0.3;
  world.arena = {.center = {100, 50, -30}, .radius = 10};
  return world;
}

/// Adds a ball at a place relative to the arena's centre.
void addBall(World& world, const Vec3& place, const Vec3& velocity, double radius = 0.5,
             double mass = 1) {
  world.balls.add({.position = world.arena.center + place, .velocity = velocity}, radius, mass);
}

Manifold groundOf(World& world, std::vector<Vec3>& force) {
  Manifold manifold;
  force.assign(world.balls.size(), Vec3::Zero());
  detectGround(world, force, manifold);
  return manifold;
}

TEST(ReferenceDetection, Ground) {
  World world = emptyWorld();
  addBall(world, {0, 0.5, 0}, {0, -2, 0});   // touches: y - r < 0 does not hold
  addBall(world, {3, 0.25, 0}, {1, -2, 0});  // reaches in by 0.25
  std::vector<Vec3> force;
  const Manifold manifold = groundOf(world, force);
  ASSERT_EQ(manifold.size(), 1u);
  EXPECT_EQ(manifold[0], (ManifoldContact{1, kNoBall, {0, 1, 0}, 0.25}));
  EXPECT_EQ(force[1], Vec3::Zero()) << "too fast to roll";
  EXPECT_EQ(world.balls.velocity[1].y(), -2);
}

TEST(ReferenceFlaws, RollingResistanceGrowsWithSpeed) {
  World world = emptyWorld();
  addBall(world, {0, 0.25, 0}, {2, 0.25, -1}, 0.5, 4);
  addBall(world, {3, 0.25, 0}, {4, -0.25, -2}, 0.5, 4);
  std::vector<Vec3> force;
  groundOf(world, force);
  // mu |m g| = 0.3 * 4 * 10 = 12 N per m/s. Coulomb's friction would be 12 N for both.
  EXPECT_NEAR(length(force[0] - Vec3(-24, 0, 12)), 0, 1e-13);
  EXPECT_NEAR(length(force[1] - Vec3(-48, 0, 24)), 0, 1e-13);
  EXPECT_EQ(world.balls.velocity[0], Vec3(2, 0, -1));
  EXPECT_EQ(world.balls.velocity[1], Vec3(4, 0, -2));
}

TEST(ReferenceFlaws, WallPenetrationForgetsTheRadius) {
  World world = emptyWorld();
  addBall(world, {9.25, 5, 0}, {1, 0, 0});     // 0.25 m short of touching
  addBall(world, {5.76, 5, 7.68}, {1, 0, 0});  // centre at 9.6: overlaps by 0.1
  addBall(world, {0, 5, -10.25}, {1, 0, 0});   // centre outside by 0.25: overlaps by 0.75
  Manifold manifold;
  detectWall(world, manifold);
  ASSERT_EQ(manifold.size(), 2u);
  EXPECT_EQ(manifold[0].first, 1u);
  EXPECT_NEAR(length(manifold[0].normal - Vec3(-0.6, 0, -0.8)), 0, 1e-13);
  EXPECT_NEAR(manifold[0].penetration, -0.4, 1e-13) << "0.1 - r";
  EXPECT_EQ(manifold[1], (ManifoldContact{2, kNoBall, {0, 0, 1}, 0.25}));
}

TEST(ReferenceFlaws, EachPairIsFoundTwice) {
  World world = emptyWorld();
  addBall(world, {0, 5, 0}, {0, 0, 0});
  addBall(world, {3, 5, 0}, {0, 0, 0});
  addBall(world, {0.75, 5, 0}, {0, 0, 0});
  Manifold manifold;
  TouchingPairs pairs;
  detectPairs(world, pairs, manifold);
  ASSERT_EQ(manifold.size(), 2u);
  EXPECT_EQ(manifold[0], (ManifoldContact{0, 2, {-1, 0, 0}, 0.25}));
  EXPECT_EQ(manifold[1], (ManifoldContact{2, 0, {1, 0, 0}, 0.25}));
}

TEST(ReferenceDetection, CoincidentCentresGetAVerticalNormal) {
  World world = emptyWorld();
  addBall(world, {1, 5, 1}, {0, 0, 0});
  addBall(world, {1, 5, 1}, {0, 0, 0});
  Manifold manifold;
  TouchingPairs pairs;
  detectPairs(world, pairs, manifold);
  ASSERT_EQ(manifold.size(), 2u);
  EXPECT_EQ(manifold[0], (ManifoldContact{0, 1, {0, 1, 0}, 1}));
  EXPECT_EQ(manifold[1], (ManifoldContact{1, 0, {0, -1, 0}, 1}));
}

/// The report's detection of pairs, word for word: all i, all other j, d^2 <= (r1 + r2)^2.
Manifold allPairs(const World& world) {
  const Balls& balls = world.balls;
  Manifold manifold;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    for (std::uint32_t j = 0; j < balls.size(); ++j) {
      if (i == j) continue;
      const Vec3 apart = balls.position[i] - balls.position[j];
      const double reach = balls.radius[i] + balls.radius[j];
      if (!(squaredLength(apart) <= reach * reach)) continue;
      const double d = length(apart);
      const Vec3 normal = d == 0 ? Vec3(0, i < j ? 1 : -1, 0) : Vec3(apart / d);
      manifold.push_back({i, j, normal, reach - d});
    }
  }
  return manifold;
}

void expectAllPairs(const World& world, std::size_t atLeast) {
  Manifold manifold;
  TouchingPairs pairs;
  detectPairs(world, pairs, manifold);
  const Manifold expected = allPairs(world);
  EXPECT_GE(expected.size(), atLeast);
  EXPECT_TRUE(manifold == expected) << manifold.size() << " for " << expected.size();
}

TEST(ReferenceDetection, SweepFindsExactlyAllPairsInRandomCrowds) {
  Random random(1);
  for (int round = 0; round < 20; ++round) {
    World world = emptyWorld();
    for (int i = 0; i < 300; ++i) {
      const double radius = round % 2 == 0 ? 0.5 : random.uniform(0.1, 1.5);
      addBall(world, {random.uniform(-5, 5), random.uniform(0, 5), random.uniform(-5, 5)},
              Vec3::Zero(), radius);
    }
    expectAllPairs(world, 300);
  }
}

// Spacing exactly 2 r (and, with thirds, 2 r give or take a rounding): every d^2 <= (2 r)^2 sits on
// the edge, along x too, where the sweep must not be stricter than the test itself.
TEST(ReferenceDetection, SweepFindsExactlyAllPairsOfTouchingLattices) {
  for (const double radius : {0.5, 1.0 / 3, 0.1}) {
    for (const double offset : {0.0, 1e-3, 1e6 / 3}) {
      World world = emptyWorld();
      world.arena.center = {offset, 0, offset};
      for (int i = 0; i < 512; ++i) {
        const int k = i * 331 % 512;  // ids not in order of place
        addBall(world, Vec3(k % 8, k / 8 % 8, k / 64) * (2 * radius), Vec3::Zero(), radius);
      }
      // All of the 3 * 7 * 8 * 8 neighbours, twice, where sums are exact; else some.
      expectAllPairs(world, radius == 0.5 && offset == 0 ? 2688 : 300);
    }
  }
}

TEST(ReferenceDetection, BallsWithoutAPlaceTouchNobody) {
  World world = emptyWorld();
  for (const double x : {0.0, std::numeric_limits<double>::quiet_NaN(), 0.5,
                         std::numeric_limits<double>::infinity(), 0.75}) {
    addBall(world, {x, 5, 0}, Vec3::Zero());
  }
  addBall(world, {0.25, std::numeric_limits<double>::quiet_NaN(), 0}, Vec3::Zero());
  expectAllPairs(world, 6);
}

}  // namespace
}  // namespace wells
