// Scenes with exact answers (exact_answers.h): one ball of radius 0.5 m and 1 kg and one well at
// rest; e = 1, mu = 0.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// No gravity; well at (0, 20, 0), S = 1000, softening 2 m; from (10, 20, 0) with 6 m/s along z.
World makeOrbit(std::size_t balls, std::uint64_t seed);

/// The same with the speed of a circle: sqrt(S r^2 / (r^2 + softening^2)^(3/2)), r = 10 m.
World makeCircularOrbit(std::size_t balls, std::uint64_t seed);

/// The same, but released at rest 0.01 m from the well's centre.
World makeThroughTheCentre(std::size_t balls, std::uint64_t seed);

/// Standard gravity; well at (0, 3, 0), S = 50, softening 2 m; from rest at (4, 3, 0) it bounces on
/// the ground.
World makeWellBounces(std::size_t balls, std::uint64_t seed);

}  // namespace wells
