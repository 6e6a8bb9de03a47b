// staysApart() promises that two things do not meet within a step. Held against brute force: in
// random worlds, what it calls apart is followed through the step in many small parts, and must not
// touch. It must also be worth its while: most of what does not meet is called apart.
#include <gtest/gtest.h>

#include <algorithm>

#include "contacts/impact_time.h"
#include "math/random.h"

namespace wells {
namespace {

constexpr double kDt = 1.0 / 60;  // s
constexpr int kParts = 400;       // of a step, in which brute force looks
constexpr double kScale = 3;      // m, of the worlds: a step's way is a radius or so

Vec3 anywhere(Random& random, double scale) {
  return {random.uniform(-scale, scale), random.uniform(-scale, scale),
          random.uniform(-scale, scale)};
}

/// Two balls near each other, or one near ground or wall, about as far as a step's way; wells among
/// them, drag, and gravity in any direction.
class RandomWorld {
 public:
  RandomWorld(std::uint64_t seed, bool hasForces) : random_(seed) {
    arena_.radius = 20;
    if (hasForces) {
      field_.gravity = anywhere(random_, 15);
      for (std::uint64_t n = random_.below(4); n > 0; --n)
        field_.wells.push_back({.position = anywhere(random_, kScale),
                                .velocity = anywhere(random_, 10),
                                .strength = random_.uniform(-3000, 3000),
                                .softening = random_.uniform(0.5, 3)});
      drag_ = random_.below(2) == 0 ? 1 : random_.uniform(0.1, 1);
    }
    field_.stretches = stretchesOf(field_.wells, kDt);
    field_.stretch = kDt / static_cast<double>(field_.stretches);
    const double fastest = random_.uniform(1, 60);
    for (int i = 0; i < 2; ++i)
      balls_.add({.position = anywhere(random_, kScale), .velocity = anywhere(random_, fastest)},
                 random_.uniform(0.2, 1), 1);
    const std::uint32_t partners[] = {1, kGround, kWall};
    partner_ = partners[random_.below(3)];
    if (partner_ == kGround) balls_.position[0].y() = balls_.radius[0] + random_.uniform(0, 1);
    if (partner_ == kWall)
      balls_.position[0].x() = arena_.radius - balls_.radius[0] - random_.uniform(0, 1.5);
  }

  /// m; < 0 is overlap.
  double gapAt(double t) const {
    const Path a{balls_.state(0), 0, balls_.radius[0]};
    const Vec3 x = stateAt(model(), a, t).position;
    if (partner_ == kGround) return groundGap(arena_, x, a.radius);
    if (partner_ == kWall) return wallGap(arena_, x, a.radius);
    const Path b{balls_.state(1), 0, balls_.radius[1]};
    return length(stateAt(model(), b, t).position - x) - a.radius - b.radius;
  }

  double smallestGap() const {
    double smallest = gapAt(0);
    for (int k = 1; k <= kParts; ++k) smallest = std::min(smallest, gapAt(kDt * k / kParts));
    return smallest;
  }

  /// With the bound on what bends the paths taken `share` times.
  bool staysApart(double share) const {
    double pull[2];
    for (std::uint32_t i = 0; i < 2; ++i) {
      const BallState ball = balls_.state(i);
      pull[i] = share * accelerationBound(model(), {ball, 0, balls_.radius[i]}, ball, 0, kDt);
    }
    return wells::staysApart(model(), balls_, pull, 0, partner_, kDt);
  }

 private:
  PathModel model() const { return {&field_, &findIntegrator("pefrl"), &arena_, drag_, 0, 0}; }

  Random random_;
  Field field_;
  Arena arena_;
  double drag_ = 1;
  Balls balls_;
  std::uint32_t partner_ = 1;
};

struct Count {
  int apart = 0;     // and said so
  int missed = 0;    // not said so, but apart
  int touching = 0;  // but said to be apart
};

Count countOf(int worlds, bool hasForces, double share) {
  Count count;
  for (int seed = 0; seed < worlds; ++seed) {
    const RandomWorld world(static_cast<std::uint64_t>(seed), hasForces);
    if (world.gapAt(0) <= 0) continue;
    const bool isApart = world.smallestGap() > 0;
    const bool isSaid = world.staysApart(share);
    count.touching += isSaid && !isApart ? 1 : 0;
    count.apart += isSaid && isApart ? 1 : 0;
    count.missed += !isSaid && isApart ? 1 : 0;
  }
  return count;
}

TEST(StaysApart, NothingThatItCallsApartMeets) {
  for (const bool hasForces : {false, true}) {
    const Count count = countOf(4000, hasForces, 1);
    EXPECT_EQ(count.touching, 0) << "forces: " << hasForces;
    EXPECT_GT(count.apart, 4 * count.missed) << "forces: " << hasForces;
  }
}

TEST(StaysApart, ABoundThatIsTooSmallIsNoticed) {
  EXPECT_GT(countOf(4000, true, 0.1).touching, 0);
}

TEST(StaysApart, WhatTouchesIsNotApart) {
  const Arena arena;
  const Field field;
  const PathModel model{&field, &findIntegrator("pefrl"), &arena, 1, 0, 0};
  Balls balls;
  balls.add({.position = {0, 0.5, 0}}, 0.5, 1);
  balls.add({.position = {1, 0.5, 0}, .velocity = {1, 0, 0}}, 0.5, 1);
  const double pull[] = {0, 0};
  EXPECT_FALSE(staysApart(model, balls, pull, 0, 1, kDt));
  EXPECT_FALSE(staysApart(model, balls, pull, 0, kGround, kDt));
  EXPECT_TRUE(staysApart(model, balls, pull, 0, kWall, kDt));
}

}  // namespace
}  // namespace wells
