// Runs a world with our engine, and adds up what it counted.
#pragma once

#include <cmath>
#include <cstdint>

#include "world/simulation.h"

namespace wells {

struct RunCounts {
  std::int64_t impacts = 0;
  std::int64_t latePairs = 0;
  std::int64_t substepBalls = 0;
  std::int64_t handedOver = 0;
  std::int64_t flightStretches = 1;  // of the last step
};

inline RunCounts run(World& world, std::int64_t steps) {
  const auto simulation = makeSimulation();
  RunCounts sum;
  for (std::int64_t i = 0; i < steps; ++i) {
    simulation->step(world);
    const StepCounts counts = simulation->counts();
    sum.impacts += counts.impacts;
    sum.latePairs += counts.latePairs;
    sum.substepBalls += counts.substepBalls;
    sum.handedOver += counts.handedOver;
    sum.flightStretches = counts.flightStretches;
  }
  return sum;
}

/// The same for `duration` (s), a multiple of the world's dt.
inline RunCounts runFor(World& world, double duration) {
  return run(world, std::llround(duration / world.settings.dt));
}

}  // namespace wells
