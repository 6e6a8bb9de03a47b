// Scenes with exact answers. All: balls of radius 0.5 m and 1 kg, y up.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// e = 1, mu = 0: released at rest at y = 5.5 m. Period 2 sqrt(2 h / g), h = 5 m.
World makeElasticBounce(std::size_t balls, std::uint64_t seed);

/// mu = 0.3: starts on the ground with 5 m/s along x and no spin; rolls at 5/7 of that after
/// 2 v / (7 mu g).
World makeSlideToRoll(std::size_t balls, std::uint64_t seed);

/// e = 1, mu = 0, no gravity: A (0, 1, 0) with 5 m/s along x hits B (3, 1, 0.4), which hits
/// C (8, 1, 2.4).
World makeBilliard(std::size_t balls, std::uint64_t seed);

/// e = 1, mu = 0, no gravity, R = 10 m: from (0, 1, 3) with 5 m/s along x.
World makeCircleBilliard(std::size_t balls, std::uint64_t seed);

/// No gravity; well at (0, 20, 0), S = 1000, softening 2 m; from (10, 20, 0) with 6 m/s along z.
World makeOrbit(std::size_t balls, std::uint64_t seed);

}  // namespace wells
