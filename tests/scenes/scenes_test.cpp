#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "forces/field.h"
#include "scenes/catalogue.h"
#include "scenes/own_well.h"
#include "scenes/scatter.h"

namespace wells {
namespace {

double smallestGap(const World& world) {
  const Balls& b = world.balls;
  double smallest = 1e9;
  for (std::size_t i = 0; i < b.size(); ++i)
    for (std::size_t j = i + 1; j < b.size(); ++j)
      smallest =
          std::min(smallest, (b.position[i] - b.position[j]).norm() - b.radius[i] - b.radius[j]);
  return smallest;
}

TEST(Catalogue, EveryWorldIsAllowedAtTheStart) {
  for (const Scene& scene : scenes()) {
    const World world = makeScene(scene, scene.fixedBalls != 0 ? 0 : 700);
    EXPECT_EQ(world.balls.size(), scene.fixedBalls != 0 ? scene.fixedBalls : 700) << scene.name;
    EXPECT_GE(smallestGap(world), -1e-15) << scene.name;  // a pile touches, but for rounding
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      EXPECT_GE(world.balls.position[i].y(), world.balls.radius[i]) << scene.name;
      EXPECT_LE(std::hypot(world.balls.position[i].x(), world.balls.position[i].z()) +
                    world.balls.radius[i],
                world.arena.radius)
          << scene.name;
    }
  }
}

TEST(Catalogue, CrowdsHaveTheirPublishedSizes) {
  const World t1 = makeScene(findScene("T1"));
  EXPECT_EQ(t1.balls.size(), 10000u);
  EXPECT_EQ(t1.arena.radius, 40);
  EXPECT_EQ(t1.tracks.size(), 4u);
  EXPECT_DOUBLE_EQ(t1.tracks[0].keyframes[0].strength, 9.81 * 1600 / 8);
  EXPECT_EQ(makeScene(findScene("T1"), 25).arena.radius, 40);
  EXPECT_NEAR(makeScene(findScene("T1"), 1000).arena.radius, 12.649110640673518, 1e-14);
  const World t2 = makeScene(findScene("T2"));
  EXPECT_EQ(t2.arena.radius, 80);
  double top = 0;
  for (std::size_t i = 0; i < t2.balls.size(); ++i) {
    EXPECT_NEAR(length(t2.balls.velocity[i]), 5, 1e-14);
    top = std::max(top, t2.balls.position[i].y());
  }
  EXPECT_NEAR(top, 1 + 2 * 2.4, 1e-14);  // three layers
  for (const Vec3& x : makeScene(findScene("T3")).balls.position) EXPECT_EQ(x.y(), 0.5);
}

// As its sources have them (yaml/bouncing.yaml, 666.yaml, 666-elastic.yaml).
TEST(Catalogue, SimBenchmarkHasItsPublishedParameters) {
  for (const char* name : {"bouncing", "666", "elastic-666"}) {
    const World world = makeScene(findScene(name));
    EXPECT_EQ(world.settings.gravity, Vec3(0, -9.81, 0)) << name;
    EXPECT_EQ(world.settings.friction, 0) << name;
    EXPECT_EQ(world.settings.elasticity, std::string_view(name) == "666" ? 0 : 1) << name;
    EXPECT_TRUE(world.tracks.empty()) << name;
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      EXPECT_EQ(world.balls.radius[i], 0.1) << name;
      EXPECT_EQ(world.balls.mass[i], 10) << name;
      EXPECT_EQ(world.balls.velocity[i], Vec3::Zero()) << name;
    }
  }
  const World bouncing = makeScene(findScene("bouncing"));
  EXPECT_EQ(bouncing.balls.size(), 49u);
  EXPECT_NEAR(smallestGap(bouncing), 1.8, 1e-14);
  for (const Vec3& x : bouncing.balls.position) EXPECT_EQ(x.y(), 5);
  for (const auto& [name, lowest] : {std::pair{"666", 0.101}, {"elastic-666", 1.101}}) {
    const World world = makeScene(findScene(name));
    EXPECT_EQ(world.balls.size(), 216u);
    Vec3 low = world.balls.position[0];
    Vec3 high = low;
    Vec3 moved = Vec3::Zero();  // the most, from the lattice that starts at the lowest corner
    for (const Vec3& x : world.balls.position) {
      low = low.cwiseMin(x);
      high = high.cwiseMax(x);
    }
    for (const Vec3& x : world.balls.position)
      for (int axis = 0; axis < 3; ++axis)
        moved[axis] = std::max(moved[axis], std::remainder(x[axis] - low[axis], 0.21));
    EXPECT_GE(low.y(), lowest);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(high[axis] - low[axis], 5 * 0.21, 1e-3) << name;
      EXPECT_LE(moved[axis], 1e-3) << name;
      EXPECT_GE(moved[axis], 0.9e-3) << name;
    }
  }
}

TEST(Catalogue, RefusesWhatItDoesNotHave) {
  EXPECT_THROW(findScene("T4"), std::invalid_argument);
  EXPECT_THROW(makeScene(findScene("billiard"), 4), std::invalid_argument);
  EXPECT_NO_THROW(makeScene(findScene("billiard"), 3));
}

TEST(Scatter, IsSeededAndWithoutOverlapEvenInManyLayers) {
  World a, b, c;
  a.arena.radius = b.arena.radius = c.arena.radius = 6;
  a.arena.center = b.arena.center = c.arena.center = {50, -3, 20};
  scatterBalls(a, 400, 0.5, 2, 1);
  scatterBalls(b, 400, 0.5, 2, 1);
  scatterBalls(c, 400, 0.5, 2, 2);
  EXPECT_GT(smallestGap(a), 0);
  EXPECT_EQ(a.balls.position, b.balls.position);
  EXPECT_NE(a.balls.position, c.balls.position);
  EXPECT_EQ(a.balls.mass[17], 2);
  for (const Vec3& x : a.balls.position) {
    EXPECT_GT(x.y(), -3 + 0.5);
    EXPECT_LT(std::hypot(x.x() - 50, x.z() - 20), 5.5);
  }
}

TEST(Scatter, RefusesABallThatDoesNotFit) {
  World world;
  world.arena.radius = 0.5;
  EXPECT_THROW(scatterBalls(world, 1, 0.5, 1, 1), std::invalid_argument);
}

// The report does not fix the wells; ours pull g/8 at half the arena's radius.
TEST(OwnWell, PullsAnEighthOfGravityAtHalfTheRadius) {
  const Arena arena{.radius = 40};
  const WellTrack track = defaultWell(arena, 0.5, PeerId{1});
  const Field field{.wells = {wellAt(track, 0, 1.0 / 60)}};
  const Vec3 at = track.keyframes[0].position + Vec3(0, 0, 20);
  EXPECT_NEAR(length(acceleration(field, at, 0)), 9.81 / 8, 1e-14);
}

TEST(OwnWell, PeersAreSpreadEvenlyOnTheCircle) {
  const Arena arena{.center = {1, 2, 3}, .radius = 40};
  const Vec3 expected[] = {{20, 0.5, 0}, {-20, 0.5, 0}, {0, 0.5, 20}, {0, 0.5, -20}};
  for (int id = 1; id <= 4; ++id)
    EXPECT_LE(length(defaultWellPosition(arena, 0.5, PeerId{id}) - arena.center - expected[id - 1]),
              1e-14);
}

}  // namespace
}  // namespace wells
