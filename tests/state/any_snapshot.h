// Snapshots in which no field has its default, and their comparison bit by bit, written out
// independently of the codec.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "math/random.h"
#include "state/snapshot.h"

namespace wells {

// Any bit pattern: tiny and huge numbers, infinities, NaNs with a payload.
inline double anyDouble(Random& random) {
  return std::bit_cast<double>(random.bits());
}

inline Vec3 anyVector(Random& random) {
  return {anyDouble(random), anyDouble(random), anyDouble(random)};
}

inline double anyLength(Random& random) {
  return random.uniform(0.1, 5);
}

inline std::vector<Vec3> anyVectors(Random& random, std::size_t count) {
  std::vector<Vec3> vectors(count);
  for (Vec3& v : vectors) v = anyVector(random);
  return vectors;
}

inline StepperMemory::Contact anyContact(Random& random, std::uint32_t a, std::uint32_t b) {
  return {.a = a,
          .b = b,
          .normalImpulse = anyDouble(random),
          .tangentImpulse = anyVector(random),
          .rollingImpulse = anyVector(random)};
}

inline Snapshot anySnapshot(std::uint64_t seed, std::size_t balls) {
  Random random(seed);
  Snapshot s;
  World& world = s.world;
  world.settings = {
      .dt = random.uniform(1e-6, 1),
      .gravity = 10 * random.direction(),
      .drag = random.uniform(0.1, 0.9),
      .elasticity = random.uniform(0.1, 0.7),
      .friction = random.uniform(1, 2),
      .rollingResistance = random.uniform(3, 4),
      .integrator = "integrator-" + std::to_string(random.below(1000)),
      .contactMethod = random.below(2) == 1 ? ContactMethod::Exact : ContactMethod::Substep,
      .substeps = static_cast<int>(5 + random.below(100)),
      .iterations = static_cast<int>(200 + random.below(100)),
      .mostImpacts = static_cast<std::int64_t>(random.below(1u << 20)) + (1ll << 40),
      .sleepSpeed = random.uniform(0.1, 0.7),
      .broadphase = seed % 2 == 1 ? BroadphaseKind::Tree : BroadphaseKind::Grid};
  world.arena = {.center = 100 * random.direction(), .radius = random.uniform(50, 90)};
  for (int t = 0; t < 3; ++t) {
    WellTrack& track = world.tracks.emplace_back();
    for (int k = 0; k <= 2 * t; ++k) {
      track.keyframes.push_back(
          {.step = -50 + 100 * k + static_cast<std::int64_t>(random.below(90)),
           .position = 30 * random.direction(),
           .strength = random.uniform(-900, 900)});
    }
    track.softening = anyLength(random);
    track.peer = PeerId{static_cast<std::int32_t>(1 + random.below(kMaxPeerId))};
  }
  for (std::uint32_t i = 0; i < balls; ++i) {
    world.balls.add({anyVector(random), anyVector(random), anyVector(random)}, anyLength(random),
                    anyLength(random));
    world.roles.push_back(random.below(2) == 1 ? Role::Ghost : Role::Owned);
    s.memory.stepsInSubsteps.push_back(static_cast<std::uint8_t>(random.below(kCrowdSteps + 1)));
    StepperMemory::Rest& rest = s.memory.rest;
    rest.group.push_back(i % 3 == 0 ? StepperMemory::kAwake : i % 3 == 1 ? i : i - 1);
    rest.steps.push_back(static_cast<std::uint32_t>(random.below(1u << 20)));
    rest.isGhost.push_back(static_cast<std::uint8_t>(random.below(2)));
    if (random.below(2) == 1) world.changed.add(i);
  }
  s.memory.rest.conditions = random.bits();
  for (std::size_t i = 0; i < balls; ++i) s.memory.rest.speed.push_back(anyDouble(random));
  s.memory.rest.position = anyVectors(random, balls);
  s.memory.rest.acceleration = anyVectors(random, balls);
  world.step = static_cast<std::int64_t>(random.below(1ull << 50)) + 1;
  for (std::uint32_t i = 1; i < balls; ++i) {
    s.memory.ballContacts.push_back(anyContact(random, i - 1, i));
    s.memory.arenaContacts.push_back(anyContact(random, i, i % 2 == 0 ? 0xffffffff : 0xfffffffe));
  }
  s.memory.carried = {.position = anyVectors(random, balls),
                      .velocity = anyVectors(random, balls),
                      .lastVelocity = anyVectors(random, balls),
                      .force = anyVectors(random, balls)};
  s.engine = "engine-" + std::to_string(random.below(1000));
  s.config = {{"Key", std::string("a\0b\n=", 5)}, {"", "empty name"}, {"Empty", ""}};
  return s;
}

inline bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

inline bool same(const Vec3& a, const Vec3& b) {
  return same(a.x(), b.x()) && same(a.y(), b.y()) && same(a.z(), b.z());
}

inline bool same(const WellKeyframe& a, const WellKeyframe& b) {
  return a.step == b.step && same(a.position, b.position) && same(a.strength, b.strength);
}

inline bool same(const StepperMemory::Contact& a, const StepperMemory::Contact& b) {
  return a.a == b.a && a.b == b.b && same(a.normalImpulse, b.normalImpulse) &&
         same(a.tangentImpulse, b.tangentImpulse) && same(a.rollingImpulse, b.rollingImpulse);
}

inline bool same(const WellTrack& a, const WellTrack& b);

template <class Item>
bool same(const std::vector<Item>& a, const std::vector<Item>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Item& x, const Item& y) { return same(x, y); });
}

inline bool same(const WellTrack& a, const WellTrack& b) {
  return same(a.keyframes, b.keyframes) && same(a.softening, b.softening) && a.peer == b.peer;
}

inline void expectSame(const Snapshot& a, const Snapshot& b) {
  const Settings& s = a.world.settings;
  const Settings& t = b.world.settings;
  EXPECT_TRUE(same(s.dt, t.dt));
  EXPECT_TRUE(same(s.gravity, t.gravity));
  EXPECT_TRUE(same(s.drag, t.drag));
  EXPECT_TRUE(same(s.elasticity, t.elasticity));
  EXPECT_TRUE(same(s.friction, t.friction));
  EXPECT_TRUE(same(s.rollingResistance, t.rollingResistance));
  EXPECT_EQ(s.integrator, t.integrator);
  EXPECT_EQ(s.contactMethod, t.contactMethod);
  EXPECT_EQ(s.substeps, t.substeps);
  EXPECT_EQ(s.iterations, t.iterations);
  EXPECT_EQ(s.mostImpacts, t.mostImpacts);
  EXPECT_TRUE(same(s.sleepSpeed, t.sleepSpeed));
  EXPECT_EQ(s.broadphase, t.broadphase);
  EXPECT_TRUE(same(a.world.arena.center, b.world.arena.center));
  EXPECT_TRUE(same(a.world.arena.radius, b.world.arena.radius));
  EXPECT_TRUE(same(a.world.tracks, b.world.tracks));
  EXPECT_TRUE(same(a.world.balls.position, b.world.balls.position));
  EXPECT_TRUE(same(a.world.balls.velocity, b.world.balls.velocity));
  EXPECT_TRUE(same(a.world.balls.spin, b.world.balls.spin));
  EXPECT_TRUE(same(a.world.balls.radius, b.world.balls.radius));
  EXPECT_TRUE(same(a.world.balls.mass, b.world.balls.mass));
  EXPECT_EQ(a.world.roles, b.world.roles);
  EXPECT_EQ(a.world.step, b.world.step);
  EXPECT_EQ(a.world.changed.list(), b.world.changed.list());
  EXPECT_TRUE(same(a.memory.ballContacts, b.memory.ballContacts));
  EXPECT_TRUE(same(a.memory.arenaContacts, b.memory.arenaContacts));
  EXPECT_EQ(a.memory.stepsInSubsteps, b.memory.stepsInSubsteps);
  const StepperMemory::Rest& r = a.memory.rest;
  const StepperMemory::Rest& q = b.memory.rest;
  EXPECT_EQ(r.conditions, q.conditions);
  EXPECT_EQ(r.group, q.group);
  EXPECT_EQ(r.steps, q.steps);
  EXPECT_TRUE(same(r.speed, q.speed));
  EXPECT_TRUE(same(r.position, q.position));
  EXPECT_TRUE(same(r.acceleration, q.acceleration));
  EXPECT_EQ(r.isGhost, q.isGhost);
  EXPECT_TRUE(same(a.memory.carried.position, b.memory.carried.position));
  EXPECT_TRUE(same(a.memory.carried.velocity, b.memory.carried.velocity));
  EXPECT_TRUE(same(a.memory.carried.lastVelocity, b.memory.carried.lastVelocity));
  EXPECT_TRUE(same(a.memory.carried.force, b.memory.carried.force));
  EXPECT_EQ(a.engine, b.engine);
  EXPECT_EQ(a.config, b.config);
}

}  // namespace wells
