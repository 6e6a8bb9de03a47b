// The resolver against impacts by hand, and against the report's own loop with a plain scan.
#include "reference/resolver.h"

#include <gtest/gtest.h>

#include "math/random.h"

namespace wells {
namespace {

Balls twoBalls(double m1, double v1, double m2, double v2) {
  Balls balls;
  balls.add({.position = {0, 0, 0}, .velocity = {v1, 0, 0}}, 0.5, m1);
  balls.add({.position = {0.6, 0, 0}, .velocity = {v2, 0, 0}}, 0.5, m2);
  return balls;
}

Manifold foundTwice(double penetration) {
  return {{0, 1, {-1, 0, 0}, penetration}, {1, 0, {1, 0, 0}, penetration}};
}

// v1' = v1 - (1 + e) m2/(m1 + m2) (v1 - v2), v2' = v2 + (1 + e) m1/(m1 + m2) (v1 - v2); the overlap
// is shared the same way.
TEST(ReferenceResolver, HeadOnImpact) {
  Balls balls = twoBalls(1, 4, 3, -2);
  Manifold manifold = foundTwice(0.4);
  Resolver resolver;
  const auto taken = resolver.resolve(manifold, balls, {.elasticity = 0.5, .maxIterations = 4});
  EXPECT_EQ(taken, 1) << "the pair's second entry separates by then";
  EXPECT_NEAR(balls.velocity[0].x(), 4 - 1.5 * 0.75 * 6, 1e-14);
  EXPECT_NEAR(balls.velocity[1].x(), -2 + 1.5 * 0.25 * 6, 1e-14);
  EXPECT_NEAR(balls.position[0].x(), -0.3, 1e-15);
  EXPECT_NEAR(balls.position[1].x(), 0.7, 1e-15);
  EXPECT_NEAR(manifold[0].penetration, 0, 1e-15);
  EXPECT_NEAR(manifold[1].penetration, 0, 1e-15);
}

TEST(ReferenceResolver, SlowPairsBounceSinceBothFallAlike) {
  Balls balls = twoBalls(1, 0.03, 1, 0);
  Manifold manifold = foundTwice(0.4);
  Resolver{}.resolve(manifold, balls,
                     {.elasticity = 1, .acceleration = {-10, 0, 0}, .h = 0.1, .maxIterations = 4});
  EXPECT_NEAR(balls.velocity[0].x(), 0, 1e-16);
  EXPECT_NEAR(balls.velocity[1].x(), 0.03, 1e-16);
}

double bounceOffGround(double elasticity, double vy) {
  Balls balls;
  balls.add({.velocity = {3, vy, 0}}, 0.5, 2);
  Manifold manifold = {{0, kNoBall, {0, 1, 0}, 0}};
  Resolver{}.resolve(
      manifold, balls,
      {.elasticity = elasticity, .acceleration = {0, -10, 0}, .h = 0.1, .maxIterations = 1});
  EXPECT_EQ(balls.velocity[0].x(), 3) << "no friction impulse";
  return balls.velocity[0].y();
}

// a_s = -10 * 0.1 = -1 m/s: v_s' = e (|v_y| - 1), 0 where that is below 0.1.
TEST(ReferenceResolver, RestingClampAndWhatGravityBuiltUp) {
  EXPECT_NEAR(bounceOffGround(1, -3), 2, 1e-15);
  EXPECT_NEAR(bounceOffGround(0.5, -3), 1, 1e-15);
  EXPECT_NEAR(bounceOffGround(0.5, -1.21), 0.105, 1e-15);
  EXPECT_NEAR(bounceOffGround(0.5, -1.19), 0, 1e-15) << "0.095 is clamped";
  EXPECT_NEAR(bounceOffGround(0.5, -0.6), 0, 1e-15) << "never downwards";
}

TEST(ReferenceResolver, StopsAtTheLimitAndLeavesTheRest) {
  Balls balls;
  for (int i = 0; i < 3; ++i) balls.add({.velocity = {0, -2.0 - i % 2, 0}}, 0.5, 1);
  Manifold manifold;
  for (std::uint32_t i = 0; i < 3; ++i) manifold.push_back({i, kNoBall, {0, 1, 0}, 0});
  Resolver resolver;
  EXPECT_EQ(resolver.resolve(manifold, balls, {.elasticity = 1, .maxIterations = 2}), 2);
  EXPECT_EQ(balls.velocity[1].y(), 3) << "the fastest first";
  EXPECT_EQ(balls.velocity[0].y(), 2) << "then the first of equal ones";
  EXPECT_EQ(balls.velocity[2].y(), -2);
}

TEST(ReferenceResolver, WhatSeparatesIsLeftAloneOverlapIncluded) {
  Balls balls = twoBalls(1, -1, 1, 1);
  const Balls before = balls;
  Manifold manifold = foundTwice(0.4);
  EXPECT_EQ(Resolver{}.resolve(manifold, balls, {.maxIterations = 4}), 0);
  EXPECT_EQ(balls.position, before.position);
  EXPECT_EQ(balls.velocity, before.velocity);
}

/// The report's loop with its plain scan over all contacts.
std::int64_t scanAndResolve(Manifold& manifold, Balls& balls, const ResolverInput& input) {
  const auto speed = [&](const ManifoldContact& c) {
    Vec3 v = balls.velocity[c.first];
    if (c.second != kNoBall) v -= balls.velocity[c.second];
    return dot(v, c.normal);
  };
  const auto pushed = [&](std::uint32_t ball, const Vec3& by) {
    balls.position[ball] += by;
    for (ManifoldContact& c : manifold) {
      if (c.first == ball) c.penetration -= dot(by, c.normal);
      if (c.second == ball) c.penetration += dot(by, c.normal);
    }
  };
  for (std::int64_t n = 0; n < input.maxIterations; ++n) {
    double worst = 0;
    std::size_t at = manifold.size();
    for (std::size_t i = 0; i < manifold.size(); ++i) {
      if (speed(manifold[i]) < worst) {
        worst = speed(manifold[i]);
        at = i;
      }
    }
    for (std::size_t i = 0; i < manifold.size() && worst == 0; ++i) {
      if (speed(manifold[i]) != 0 || !(manifold[i].penetration > 0)) continue;
      at = i;
      break;
    }
    if (at == manifold.size()) return n;
    const ManifoldContact c = manifold[at];
    const double w1 = 1 / balls.mass[c.first];
    const double w2 = c.second == kNoBall ? 0 : 1 / balls.mass[c.second];
    double after = -input.elasticity * worst;
    const double built = dot(input.acceleration, c.normal) * input.h;
    if (c.second == kNoBall && built < 0) {
      after += input.elasticity * built;
      if (after < 0.1) after = 0;
    }
    const Vec3 impulse = c.normal * ((after - worst) / (w1 + w2));
    balls.velocity[c.first] += impulse * w1;
    if (c.second != kNoBall) balls.velocity[c.second] -= impulse * w2;
    if (c.penetration > 0) {
      const Vec3 push = c.normal * (c.penetration / (w1 + w2));
      pushed(c.first, push * w1);
      if (c.second != kNoBall) pushed(c.second, push * -w2);
      manifold[at].penetration = 0;
    }
  }
  return input.maxIterations;
}

TEST(ReferenceResolver, EqualsAPlainScanBitForBit) {
  Random random(3);
  Resolver resolver;
  for (int round = 0; round < 200; ++round) {
    Balls balls;
    const std::uint32_t count = 2 + static_cast<std::uint32_t>(random.below(40));
    // Whole numbers in every other round, so that many speeds are equal.
    const bool whole = round % 2 == 0;
    const auto draw = [&] {
      return whole ? static_cast<double>(random.below(5)) - 2 : random.uniform(-2, 2);
    };
    for (std::uint32_t i = 0; i < count; ++i) {
      balls.add({.position = {draw(), draw(), draw()}, .velocity = {draw(), draw(), draw()}}, 0.5,
                whole ? 1 : random.uniform(0.1, 10));
    }
    Manifold manifold;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (random.below(2) == 0) manifold.push_back({i, kNoBall, {0, 1, 0}, random.uniform(0, 0.1)});
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      for (std::uint32_t j = 0; j < count; ++j) {
        if (i == j || random.below(8) != 0) continue;
        const Vec3 normal = whole ? Vec3(1, 0, 0) : random.direction();
        manifold.push_back({i, j, normal, random.uniform(-0.1, 0.2)});
      }
    }
    const ResolverInput input{
        .elasticity = round % 3 == 0 ? 1 : 0.8,
        .acceleration = {0, -9.81, 0},
        .h = 1.0 / 60,
        .maxIterations = static_cast<std::int64_t>(random.below(2 * manifold.size() + 1))};
    Manifold expectedManifold = manifold;
    Balls expected = balls;
    const auto expectedCount = scanAndResolve(expectedManifold, expected, input);
    EXPECT_EQ(resolver.resolve(manifold, balls, input), expectedCount);
    ASSERT_EQ(balls.position, expected.position) << "round " << round;
    ASSERT_EQ(balls.velocity, expected.velocity) << "round " << round;
    ASSERT_TRUE(manifold == expectedManifold) << "round " << round;
  }
}

}  // namespace
}  // namespace wells
