// The distance of a lone ball from where it must be, for shorter and shorter steps.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "support/run_world.h"

namespace wells {

/// (Length of a piece of flight in s, distance of ball 0 from `exact` in m) after `duration` (s) of
/// worldOf(dt), for dt = 1/60, 1/120, 1/240, 1/480 s. Nothing of it may go by substeps.
template <class WorldOf>
std::vector<std::pair<double, double>> stepErrors(WorldOf worldOf, double duration,
                                                  const Vec3& exact) {
  std::vector<std::pair<double, double>> errors;
  for (int n = 60; n <= 480; n *= 2) {
    World world = worldOf(1.0 / n);
    const RunCounts counts = runFor(world, duration);
    EXPECT_EQ(counts.substepBalls, 0) << n;
    errors.emplace_back(1.0 / (n * static_cast<double>(counts.flightStretches)),
                        length(world.balls.position[0] - exact));
  }
  return errors;
}

}  // namespace wells
