#include "broadphase/broadphase.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "broadphase/resting_boxes.h"
#include "math/random.h"

namespace wells {
namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// All pairs whose gap is within the sum of their reaches: what the broadphase must not miss.
Pairs bruteForce(const World& world, const std::vector<double>& reach) {
  const Balls& b = world.balls;
  Pairs pairs;
  for (std::uint32_t i = 0; i < b.size(); ++i)
    for (std::uint32_t j = i + 1; j < b.size(); ++j)
      if (length(b.position[i] - b.position[j]) - b.radius[i] - b.radius[j] <= reach[i] + reach[j])
        pairs.emplace(i, j);
  return pairs;
}

std::vector<std::uint32_t> allOf(const World& world) {
  std::vector<std::uint32_t> all(world.balls.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

void expectComplete(const World& world, const std::vector<double>& reach, const Broadphase& found) {
  Pairs listed;
  for (const BallPair& pair : found.ballPairs()) {
    EXPECT_LT(pair.a, pair.b);
    EXPECT_TRUE(listed.empty() || *listed.rbegin() < std::pair(pair.a, pair.b)) << "not in order";
    EXPECT_TRUE(listed.emplace(pair.a, pair.b).second) << "pair listed twice";
  }
  for (const auto& pair : bruteForce(world, reach))
    EXPECT_TRUE(listed.contains(pair)) << pair.first << " " << pair.second;

  const std::set<std::uint32_t> ground(found.nearGround().begin(), found.nearGround().end());
  const std::set<std::uint32_t> wall(found.nearWall().begin(), found.nearWall().end());
  for (std::uint32_t i = 0; i < world.balls.size(); ++i) {
    const Vec3 d = world.balls.position[i] - world.arena.center;
    const double r = world.balls.radius[i] + reach[i];
    EXPECT_TRUE(d.y() > r || ground.contains(i)) << i;
    EXPECT_TRUE(std::hypot(d.x(), d.z()) + r < world.arena.radius || wall.contains(i)) << i;
  }
}

// Balls with radii between the two, at random in and around the arena.
World randomWorld(std::size_t balls, double smallest, double largest, const Vec3& center,
                  std::uint64_t seed) {
  World world;
  world.arena = {.center = center, .radius = 12};
  Random random(seed);
  for (std::size_t i = 0; i < balls; ++i) {
    const Vec3 at{random.uniform(-13, 13), random.uniform(-1, 8), random.uniform(-13, 13)};
    world.balls.add({.position = center + at, .velocity = 8 * random.direction()},
                    random.uniform(smallest, largest), 1);
  }
  return world;
}

/// Both kinds, by name.
class EachBroadphase : public testing::TestWithParam<BroadphaseKind> {
 protected:
  World withKind(World world) const {
    world.settings.broadphase = GetParam();
    return world;
  }
};

INSTANTIATE_TEST_SUITE_P(Broadphase, EachBroadphase,
                         testing::Values(BroadphaseKind::Tree, BroadphaseKind::Grid),
                         [](const auto& kind) { return std::string(name(kind.param)); });

/// Moves the balls about and compares at every step, so that boxes are kept, left and made anew.
void expectCompleteWhileMoving(World world, std::uint64_t seed) {
  Random random(seed);
  Broadphase broadphase;
  std::vector<double> reach(world.balls.size());
  for (int step = 0; step < 60; ++step) {
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      world.balls.position[i] += world.balls.velocity[i] / 60;
      reach[i] = random.uniform(0, 0.3);
      if (random.below(500) == 0) {  // another peer's state: a jump
        world.balls.position[i] += 5 * random.direction();
        reach[i] = 2;
      }
    }
    broadphase.update(world, reach, allOf(world));
    expectComplete(world, reach, broadphase);
  }
}

TEST_P(EachBroadphase, MissesNothingAmongEqualBalls) {
  expectCompleteWhileMoving(withKind(randomWorld(300, 0.5, 0.5, {0, 0, 0}, 1)), 2);
}

TEST_P(EachBroadphase, MissesNothingWithRadiiOneToAHundred) {
  expectCompleteWhileMoving(withKind(randomWorld(200, 0.02, 2, {0, 0, 0}, 3)), 4);
}

TEST_P(EachBroadphase, MissesNothingFarFromTheOrigin) {
  for (const double far : {1e6, 1e9})
    expectCompleteWhileMoving(withKind(randomWorld(200, 0.5, 0.5, {far, -2 * far, 3 * far}, 5)), 6);
}

TEST_P(EachBroadphase, MissesNothingWhenAllAreInOnePlace) {
  World world = withKind(randomWorld(120, 0.5, 0.5, {0, 0, 0}, 7));
  for (Vec3& x : world.balls.position) x = {1, 1, 1};
  expectCompleteWhileMoving(world, 8);
}

// The tree sets those boxes anew that are left, the grid all if one is left.
TEST_P(EachBroadphase, TouchesProxiesOnlyWhenABoxIsLeft) {
  const bool isTree = GetParam() == BroadphaseKind::Tree;
  World world = withKind(randomWorld(100, 0.5, 0.5, {0, 0, 0}, 9));
  const std::vector<double> reach(100, 0.1);
  Broadphase broadphase;
  broadphase.update(world, reach, allOf(world));
  EXPECT_EQ(broadphase.moved(), 100);
  world.balls.position[7].x() += 0.01;
  broadphase.update(world, reach, allOf(world));
  EXPECT_EQ(broadphase.moved(), 0);
  world.balls.position[7].x() += 1;
  broadphase.update(world, reach, allOf(world));
  EXPECT_EQ(broadphase.moved(), isTree ? 1 : 100);
}

TEST_P(EachBroadphase, LeavesOutWhatIsNotFiniteAndTakesItBack) {
  World world = withKind(randomWorld(50, 0.5, 0.5, {0, 0, 0}, 11));
  const std::vector<double> reach(50, 0.1);
  Broadphase broadphase;
  broadphase.update(world, reach, allOf(world));
  const Vec3 place = world.balls.position[3];
  world.balls.position[3].y() = std::numeric_limits<double>::quiet_NaN();
  broadphase.update(world, reach, allOf(world));
  for (const BallPair& pair : broadphase.ballPairs()) EXPECT_TRUE(pair.a != 3 && pair.b != 3);
  for (const std::uint32_t i : broadphase.nearGround()) EXPECT_NE(i, 3u);
  world.balls.position[3] = place;
  broadphase.update(world, reach, allOf(world));
  expectComplete(world, reach, broadphase);
}

TEST_P(EachBroadphase, StartsAfreshWhenTheWorldIsAnother) {
  Broadphase broadphase;
  for (const std::size_t count : {20u, 40u, 10u}) {
    const World world = withKind(randomWorld(count, 0.5, 0.5, {double(count), 0, 0}, count));
    const std::vector<double> reach(count, 0.2);
    broadphase.update(world, reach, allOf(world));
    expectComplete(world, reach, broadphase);
  }
}

// Balls that are removed are in no pair, few or many at once; they may come back.
TEST_P(EachBroadphase, LeavesOutWhatWasRemoved) {
  const World world = withKind(randomWorld(300, 0.3, 0.6, Vec3::Zero(), 4));
  const std::vector<double> reach(300, 0.2);
  Broadphase broadphase;
  broadphase.update(world, reach, allOf(world));
  for (const std::size_t count : {3u, 100u, 150u}) {
    std::vector<std::uint32_t> out = allOf(world);
    std::vector<std::uint32_t> in(out.begin() + static_cast<std::ptrdiff_t>(count), out.end());
    out.resize(count);
    broadphase.remove(out);
    broadphase.update(world, reach, in);
    Pairs listed;
    for (const BallPair& pair : broadphase.ballPairs()) {
      EXPECT_GE(pair.a, count);
      EXPECT_TRUE(listed.emplace(pair.a, pair.b).second);
    }
    for (const auto& pair : bruteForce(world, reach))
      EXPECT_TRUE(pair.first < count || listed.contains(pair)) << pair.first << " " << pair.second;
    for (const std::uint32_t i : broadphase.nearGround()) EXPECT_GE(i, count);
    for (const std::uint32_t i : broadphase.nearWall()) EXPECT_GE(i, count);
    broadphase.update(world, reach, allOf(world));
    expectComplete(world, reach, broadphase);
  }
}

// Against a look at every box, while balls come and go.
TEST(RestingBoxes, FindsWhatOverlaps) {
  const World world = randomWorld(400, 0.1, 1, {3, -2, 5}, 5);
  Random random(6);
  RestingBoxes boxes;
  std::set<std::uint32_t> there;
  for (int round = 0; round < 2000; ++round) {
    const auto ball = static_cast<std::uint32_t>(random.below(400));
    if (there.erase(ball) > 0) {
      boxes.remove(ball);
    } else {
      there.insert(ball);
      boxes.add(ball, world.balls.position[ball], world.balls.radius[ball]);
    }
    const Vec3 center = world.balls.position[random.below(400)];
    const double half = random.uniform(0, 3);
    std::vector<std::uint32_t> found;
    boxes.find(center - Vec3::Constant(half), center + Vec3::Constant(half), found);
    const std::set<std::uint32_t> sorted(found.begin(), found.end());
    EXPECT_EQ(sorted.size(), found.size()) << "each once";
    std::set<std::uint32_t> expected;
    for (const std::uint32_t i : there)
      if (((world.balls.position[i] - center).cwiseAbs().array() <= world.balls.radius[i] + half)
              .all())
        expected.insert(i);
    ASSERT_EQ(sorted, expected);
  }
  boxes.clear();
  std::vector<std::uint32_t> found;
  boxes.find(Vec3::Constant(-100), Vec3::Constant(100), found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace wells
