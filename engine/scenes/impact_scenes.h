// Scenes with exact answers (exact_answers.h): balls that hit each other and the wall. All: balls
// of radius 0.5 m, 1 kg unless said, no gravity, no wells; e = 1 and mu = 0 unless said.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// A (0, 1, 0) with 5 m/s along x hits B (3, 1, 0.4).
World makeObliqueBalls(std::size_t balls, std::uint64_t seed);

/// e = 0.8, mu = 0.3: the same, but 30 degrees off the line of centres. The surfaces stick.
World makeFrictionBallsStick(std::size_t balls, std::uint64_t seed);

/// e = 0.8, mu = 0.3: A, with 20 rad/s about z, hits B head-on. The surfaces slip.
World makeFrictionBallsSlip(std::size_t balls, std::uint64_t seed);

/// A (0, 1, 0) with 5 m/s along x hits B (3, 1, 0.4), which hits C (8, 1, 2.4).
World makeBilliard(std::size_t balls, std::uint64_t seed);

/// R = 10 m: from (0, 1, 3) with 5 m/s along x.
World makeCircleBilliard(std::size_t balls, std::uint64_t seed);

/// Newton's cradle: one ball with 1 m/s comes to a row of four, 1 mm apart.
World makeCradle(std::size_t balls, std::uint64_t seed);

/// R = 10 m: 1 kg at rest before the wall, 10^4 kg come with 2 m/s; 314 hits (Galperin, "Playing
/// pool with pi", 2003).
World makeGalperin(std::size_t balls, std::uint64_t seed);

/// e = 0.05: three balls in a row, of which the first moves with 1 m/s. Infinitely many impacts by
/// t = 2.25 s, then they move on together.
World makeCollapse(std::size_t balls, std::uint64_t seed);

/// The same with e = 0.08, just above the threshold 7 - 4 sqrt(3) = 0.0718: ten impacts.
World makeCollapseTwin(std::size_t balls, std::uint64_t seed);

}  // namespace wells
