// What the tests of sleep and of waking share.
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "scenes/crowds.h"
#include "world/simulation.h"

namespace wells {

/// A world and its engine.
struct Sleeper {
  explicit Sleeper(World start) : world(std::move(start)) {}

  void step(std::int64_t steps = 1) {
    for (std::int64_t i = 0; i < steps; ++i) simulation->step(world);
  }
  std::size_t asleep() const { return static_cast<std::size_t>(simulation->counts().asleep); }
  std::size_t awake() const { return world.balls.size() - asleep(); }

  World world;
  std::unique_ptr<Stepper> simulation = makeSimulation();
};

inline World sleepless(World world) {
  world.settings.sleepSpeed = 0;
  return world;
}

inline World settledLayer(std::size_t balls, ContactMethod method = ContactMethod::Exact) {
  World world = makeSettledLayer(balls, 1);
  world.settings.contactMethod = method;
  return world;
}

inline bool isSame(const BallState& a, const BallState& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin;
}

inline void expectSameBits(const World& a, const World& b) {
  for (std::size_t i = 0; i < a.balls.size(); ++i)
    EXPECT_TRUE(isSame(a.balls.state(i), b.balls.state(i))) << "ball " << i;
}

}  // namespace wells
