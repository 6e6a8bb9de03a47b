// The pairs that a step gets, against a look at all pairs, at every step of heaps and of a gas.
#include "world/candidates.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "contacts/contact.h"
#include "math/random.h"
#include "scenes/catalogue.h"
#include "world/advance.h"
#include "world/simulation.h"

namespace wells {
namespace {

constexpr BroadphaseKind kKinds[] = {BroadphaseKind::Tree, BroadphaseKind::Grid,
                                     BroadphaseKind::Auto};

std::vector<double> reachesOf(const World& world) {
  Field field;
  updateField(world, world.step, field);
  std::vector<double> reach;
  for (std::size_t i = 0; i < world.balls.size(); ++i)
    reach.push_back(reachOf(field, world.balls.state(i), world.balls.radius[i], world.settings.dt));
  return reach;
}

std::vector<std::uint32_t> allOf(const World& world) {
  std::vector<std::uint32_t> all(world.balls.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// By (a, b): all whose gap is at most the sum of their reaches.
std::vector<BallPair> ballPairs(const Balls& balls, const std::vector<double>& reach) {
  std::vector<BallPair> pairs;
  for (std::uint32_t a = 0; a < balls.size(); ++a)
    for (std::uint32_t b = a + 1; b < balls.size(); ++b) {
      const double bound = balls.radius[a] + reach[a] + (balls.radius[b] + reach[b]);
      if (squaredLength(balls.position[b] - balls.position[a]) <= bound * bound)
        pairs.push_back({a, b});
    }
  return pairs;
}

std::vector<BallPair> arenaPairs(const World& world, const std::vector<double>& reach) {
  std::vector<BallPair> pairs;
  for (std::uint32_t a = 0; a < world.balls.size(); ++a) {
    const Vec3& x = world.balls.position[a];
    const double radius = world.balls.radius[a];
    if (wallGap(world.arena, x, radius) <= reach[a]) pairs.push_back({a, kWall});
    if (groundGap(world.arena, x, radius) <= reach[a]) pairs.push_back({a, kGround});
  }
  return pairs;
}

/// Of each kind, used from step to step.
class Finders {
 public:
  void expectAll(World world) {
    const std::vector<double> reach = reachesOf(world);
    const auto balls = ballPairs(world.balls, reach);
    const auto arena = arenaPairs(world, reach);
    most_ = std::max(most_, balls.size());
    for (const BroadphaseKind kind : kKinds) {
      world.settings.broadphase = kind;
      Candidates& candidates = candidates_[kind];
      candidates.find(world, reach, allOf(world));
      ASSERT_TRUE(std::ranges::equal(candidates.ballPairs(), balls)) << name(kind);
      ASSERT_TRUE(std::ranges::equal(candidates.arenaPairs(), arena)) << name(kind);
    }
  }
  std::size_t most() const { return most_; }

 private:
  std::map<BroadphaseKind, Candidates> candidates_;
  std::size_t most_ = 0;
};

class Run : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Candidates, Run, testing::Values("T1", "T2"));

TEST_P(Run, HasAtEachStepThePairsOfBruteForce) {
  World world = makeScene(findScene(GetParam()), 1000);
  const auto simulation = makeSimulation();
  Finders finders;
  for (int step = 0; step < 200; ++step) {
    finders.expectAll(world);
    if (HasFatalFailure()) FAIL() << "at step " << step;
    simulation->step(world);
    EXPECT_EQ(simulation->counts().latePairs, 0);
  }
  EXPECT_GT(finders.most(), 50u);
}

/// How many pairs touch at the end of a step of 40 that were no candidates at its start, when
/// reaches are multiplied by `factor`.
int missed(BroadphaseKind kind, double factor) {
  World world = makeScene(findScene("T1"), 1000);
  world.settings.broadphase = kind;
  const auto simulation = makeSimulation();
  Candidates candidates;
  int count = 0;
  for (int step = 0; step < 40; ++step) {
    std::vector<double> reach = reachesOf(world);
    for (double& x : reach) x *= factor;
    candidates.find(world, reach, allOf(world));
    std::set<std::pair<std::uint32_t, std::uint32_t>> found;
    for (const auto& [a, b] : candidates.ballPairs()) found.emplace(a, b);
    simulation->step(world);
    for (const auto& [a, b] : ballPairs(world.balls, std::vector<double>(world.balls.size(), 0)))
      count += found.contains({a, b}) ? 0 : 1;
  }
  return count;
}

// What is found is what touches; and the look at it would notice if it were not.
TEST(Candidates, MissNothingThatTouchesUnlessReachesAreTooShort) {
  for (const BroadphaseKind kind : kKinds) {
    EXPECT_EQ(missed(kind, 1), 0) << name(kind);
    EXPECT_GT(missed(kind, 0), 10) << name(kind) << ", with no reach";
  }
}

/// 300 balls in a row, 4 m apart, that reach 0.3 m; seen by candidates of each kind, and by those
/// of few.
class Surprise : public testing::TestWithParam<std::pair<BroadphaseKind, int>> {
 protected:
  Surprise() {
    world_.settings.broadphase = GetParam().first;
    world_.arena.radius = 2000;
    for (int i = 0; i < GetParam().second; ++i)
      world_.balls.add({.position = Vec3{4.0 * i, 3, 0}}, 0.5, 1);
    reach_.assign(world_.balls.size(), 0.3);
    candidates_.find(world_, reach_, allOf(world_));
  }

  void move(std::size_t ball, const Vec3& way) { world_.balls.position[ball] += way; }

  std::vector<std::uint32_t> surprised() {
    ThreadPool alone;
    const auto found = candidates_.findSurprised(world_, reach_, allOf(world_), alone);
    return {found.begin(), found.end()};
  }

  using Balls = std::vector<std::uint32_t>;
  World world_;
  std::vector<double> reach_;
  Candidates candidates_;
};

INSTANTIATE_TEST_SUITE_P(Candidates, Surprise,
                         testing::Values(std::pair{BroadphaseKind::Tree, 300},
                                         std::pair{BroadphaseKind::Grid, 300},
                                         std::pair{BroadphaseKind::Auto, 20}));

TEST_P(Surprise, IsNobodyWhoStayedWithinReachOrMetNobody) {
  move(3, {0.29, 0, 0});
  EXPECT_EQ(surprised(), Balls());
  move(3, {2.6, 0, 0});  // 0.11 m before the next
  EXPECT_EQ(surprised(), Balls());
}

TEST_P(Surprise, IsWhoMetAnother) {
  move(3, {3.1, 0, 0});
  EXPECT_EQ(surprised(), Balls{3});
}

TEST_P(Surprise, IsWhoPassedAnotherOnItsWay) {
  move(3, {8, 1.8, 0});  // 0.88 m over the centre of the next
  EXPECT_EQ(surprised(), Balls{3});
}

TEST_P(Surprise, IsNobodyWhomAnotherMadeRoom) {
  move(3, {3.1, 0, 0});
  move(4, {0.2, 0, 0});
  EXPECT_EQ(surprised(), Balls());
}

TEST_P(Surprise, AreBothWhereBothWentFar) {
  move(3, {1.6, 0, 0});
  move(4, {-1.6, 0, 0});
  EXPECT_EQ(surprised(), (Balls{3, 4}));
}

TEST_P(Surprise, IsWhoMetTheArena) {
  move(0, {0, -2.49, 0});
  EXPECT_EQ(surprised(), Balls());
  move(0, {0, -0.02, 0});
  EXPECT_EQ(surprised(), Balls{0});
  move(7, {0, 0, 3000});
  EXPECT_EQ(surprised(), (Balls{0, 7}));
}

/// Balls of hostile worlds, which drift and jump.
World hostileWorld(const std::string& what, std::uint64_t seed) {
  Random random(seed);
  World world;
  world.arena.radius = 15;
  if (what == "far") world.arena.center = Vec3::Constant(1e6);
  if (what == "farther") world.arena.center = Vec3::Constant(1e9);
  for (int i = 0; i < 300; ++i) {
    Vec3 at{random.uniform(-14, 14), random.uniform(0, 6), random.uniform(-14, 14)};
    double radius = 0.5;
    double speed = random.uniform(0, 8);
    if (what == "one cell") at = Vec3{3, 1, 3} + 1e-3 * at;
    if (what == "one to a hundred") radius = i % 20 == 0 ? 2 : random.uniform(0.02, 0.3);
    if (what == "fast" && i % 3 == 0) speed = random.uniform(0, 2e4);
    if (what == "lost" && i % 10 == 0) at *= std::pow(10, random.uniform(3, 13));
    world.balls.add({.position = world.arena.center + at, .velocity = speed * random.direction()},
                    radius, 1);
  }
  return world;
}

class Hostile : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Candidates, Hostile,
                         testing::Values("plain", "one cell", "one to a hundred", "far", "farther",
                                         "fast", "lost"),
                         [](const auto& world) {
                           std::string text = world.param;
                           std::ranges::replace(text, ' ', '_');
                           return text;
                         });

TEST_P(Hostile, HasThePairsOfBruteForce) {
  World world = hostileWorld(GetParam(), 1);
  Random random(2);
  Finders finders;
  for (int step = 0; step < 40; ++step) {
    finders.expectAll(world);
    if (HasFatalFailure()) FAIL() << "at step " << step;
    // Every other time so little that no box is left.
    const double dt = step % 2 == 0 ? 1.0 / 60 : 1e-6;
    for (std::size_t i = 0; i < world.balls.size(); ++i) {
      world.balls.position[i] += dt * world.balls.velocity[i];
      if (random.below(100) == 0) world.balls.velocity[i] *= -1;
    }
  }
  EXPECT_GT(finders.most(), 50u);
}

}  // namespace
}  // namespace wells
