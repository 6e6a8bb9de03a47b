#include "contacts/impact_time.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "math/random.h"

namespace wells {
namespace {

constexpr double kStep = 1.0 / 60;
constexpr int kSamples = 200;

/// Balls in flight near each other, near wells that move, in a small arena.
struct Flights {
  explicit Flights(Random& random)
      : field{.gravity = {0, -9.81, 0}, .wells = {}, .stretches = 1, .stretch = kStep},
        model{&field, &findIntegrator("pefrl"), &arena, random.uniform() < 0.5 ? 1.0 : 0.5} {
    for (int i = 0; i < 3; ++i)
      field.wells.push_back({.position = at(random, 3),
                             .velocity = random.uniform(0, 20) * random.direction(),
                             .strength = random.uniform(-2000, 2000),
                             .softening = random.uniform(1, 2)});
    for (Path& path : paths) {
      path.state.position = at(random, 1.5);
      path.state.velocity = random.uniform(0, 30) * random.direction();
      path.start = random.uniform(0, kStep / 2);
      path.radius = random.uniform(0.1, 0.5);
    }
  }

  static Vec3 at(Random& random, double range) {
    return Vec3(0, 2.5, 0) + random.uniform(0, range) * random.direction();
  }

  Flyer flyer(const Path& path) const {
    return {&path, accelerationBound(model, path, path.state, path.start, kStep - path.start)};
  }

  /// What the pair's gap, or that to the arena, is at least from `from` on.
  template <class GapAt>
  static double least(double from, GapAt gapAt) {
    double least = 1e9;
    for (int i = 0; i <= kSamples; ++i)
      least = std::min(least, gapAt(from + (kStep - from) * i / kSamples));
    return least;
  }

  Arena arena{.center = {0, 0, 0}, .radius = 4};
  Field field;
  PathModel model;
  Path paths[2];
};

TEST(AccelerationBound, HoldsForWellsThatMove) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Flights flights(random);
    for (const Path& path : flights.paths) {
      const double bound = flights.flyer(path).pull;
      for (int k = 0; k <= kSamples; ++k) {
        const double t = path.start + (kStep - path.start) * k / kSamples;
        const BallState now = stateAt(flights.model, path, t);
        const Vec3 pull = acceleration(flights.field, now.position, t) - flights.field.gravity -
                          dragRate(flights.model.drag) * now.velocity;
        ASSERT_LE(length(pull), bound) << i;
      }
    }
  }
}

TEST(StatesAt, AreThoseOfEachPathToTheBit) {
  Random random(5);
  for (int i = 0; i < 500; ++i) {
    Flights flights(random);
    auto& [a, b] = flights.paths;
    if (i % 2 == 0) b.start = a.start;
    for (const double t : {a.start, random.uniform(0, kStep), kStep}) {
      const auto [nowA, nowB] = statesAt(flights.model, a, b, t);
      for (const auto& [now, path] : {std::pair{&nowA, &a}, std::pair{&nowB, &b}}) {
        const BallState expected = stateAt(flights.model, *path, t);
        ASSERT_EQ(now->position, expected.position) << i;
        ASSERT_EQ(now->velocity, expected.velocity) << i;
        ASSERT_EQ(now->spin, expected.spin) << i;
      }
    }
  }
}

// Where they say so nothing meets; and they say so of most that do not.
TEST(StayApart, IsSoAtAnyTime) {
  Random random(2);
  int open = 0;
  int apart = 0;
  for (int i = 0; i < 5000; ++i) {
    const Flights flights(random);
    const auto& [a, b] = flights.paths;
    const double from = std::max(a.start, b.start);
    const bool said = stayApart(flights.model, flights.flyer(a), flights.flyer(b), from, kStep);
    const double least = Flights::least(from, [&](double t) {
      const Vec3 d = stateAt(flights.model, a, t).position - stateAt(flights.model, b, t).position;
      return length(d) - a.radius - b.radius;
    });
    if (said) {
      ASSERT_GT(least, 0) << i;
    }
    open += least > 0 ? 1 : 0;
    apart += said ? 1 : 0;
  }
  EXPECT_LT(open, 4900);
  EXPECT_GT(apart, 3 * open / 4);
}

// The test above would notice a bound on the pull that does not hold.
TEST(StayApart, IsNotSoWithABoundThatIsTooSmall) {
  Random random(2);
  int wrong = 0;
  for (int i = 0; i < 5000; ++i) {
    const Flights flights(random);
    const auto& [a, b] = flights.paths;
    const double from = std::max(a.start, b.start);
    if (!stayApart(flights.model, {&a, 0}, {&b, 0}, from, kStep)) continue;
    const double least = Flights::least(from, [&](double t) {
      const Vec3 d = stateAt(flights.model, a, t).position - stateAt(flights.model, b, t).position;
      return length(d) - a.radius - b.radius;
    });
    wrong += least > 0 ? 0 : 1;
  }
  EXPECT_GT(wrong, 0);
}

TEST(StaysOff, IsSoAtAnyTime) {
  Random random(3);
  for (const std::uint32_t partner : {kGround, kWall}) {
    int open = 0;
    int off = 0;
    for (int i = 0; i < 5000; ++i) {
      const Flights flights(random);
      const Path& path = flights.paths[0];
      const bool said = staysOff(flights.model, flights.flyer(path), partner, kStep);
      const double least = Flights::least(path.start, [&](double t) {
        const Vec3 now = stateAt(flights.model, path, t).position;
        return partner == kGround ? groundGap(flights.arena, now, path.radius)
                                  : wallGap(flights.arena, now, path.radius);
      });
      if (said) {
        ASSERT_GT(least, 0) << i;
      }
      open += least > 0 ? 1 : 0;
      off += said ? 1 : 0;
    }
    EXPECT_GT(off, 3 * open / 4);
  }
}

TEST(LeastGap, IsNoMoreThanTheGap) {
  Random random(4);
  for (int i = 0; i < 5000; ++i) {
    const Flights flights(random);
    const auto& [a, b] = flights.paths;
    const double t = std::max(a.start, b.start) + random.uniform(0, kStep / 2);
    const Vec3 at = stateAt(flights.model, a, t).position;
    const double gap = length(stateAt(flights.model, b, t).position - at) - a.radius - b.radius;
    const double bound = leastGap(flights.model, flights.flyer(b), t, at, a.radius);
    ASSERT_LE(bound, gap + 1e-13) << i;
    ASSERT_GE(bound, gap - 0.5) << i;
  }
}

}  // namespace
}  // namespace wells
