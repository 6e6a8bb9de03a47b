// Scenes with exact answers (exact_answers.h): a ball on the ground that bounces, slides and rolls.
// All: balls of radius 0.5 m and 1 kg, y up, standard gravity unless said.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// e = 1, mu = 0: released at rest at y = 5.5 m. Period 2 sqrt(2 h / g), h = 5 m.
World makeElasticBounce(std::size_t balls, std::uint64_t seed);

/// The same with e = 0.8: infinitely many impacts until it rests, sqrt(2 h / g) (1 + e) / (1 - e) =
/// 9.087 s after the release.
World makeZeno(std::size_t balls, std::uint64_t seed);

/// The same with e = 0.5: at rest from 3.029 s on.
World makeZenoRest(std::size_t balls, std::uint64_t seed);

/// mu = 0.3: starts on the ground with 5 m/s along x and no spin; rolls at 5/7 of that after
/// 2 v / (7 mu g).
World makeSlideToRoll(std::size_t balls, std::uint64_t seed);

/// The same with 20 rad/s of backspin: rolls on at (5 v - 2 r w) / 7 = 0.714 m/s.
World makeBackspin(std::size_t balls, std::uint64_t seed);

/// The same with 40 rad/s of backspin: comes back at 2.143 m/s.
World makeBackspinReturn(std::size_t balls, std::uint64_t seed);

/// mu = 0.3: on the ground at rest, 0.1 m from a well of S = 8, softening 2 m, at the height of its
/// centre: rolls to and fro with 5/7 of the well's pull.
World makeRollingUnderWell(std::size_t balls, std::uint64_t seed);

/// mu = 0.3, rolling resistance b = 0.1 m: starts on the ground with 5 m/s along x and no spin;
/// rolls at 2.27 m/s after v / ((7/2 mu - 5/2 b/r) g) = 0.927 s, slows down by 5/7 b/r g and rests
/// from 2.548 s on.
World makeRollingStops(std::size_t balls, std::uint64_t seed);

/// As makeRollingUnderWell, but 1 m from the well and with a rolling resistance of 0.01 m: rolls to
/// -0.513 m and back to 0.101 m, where the well cannot move it any more.
World makeStuckUnderWell(std::size_t balls, std::uint64_t seed);

/// No gravity, e = 0.8, mu = 0.3: two balls, far apart, come down to the ground at 5 m/s, 60 and 65
/// degrees from the normal. The first sticks at the impact, the second slides through it.
World makeObliqueGround(std::size_t balls, std::uint64_t seed);

}  // namespace wells
