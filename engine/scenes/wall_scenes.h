// Scenes with exact answers (exact_answers.h): a ball that the wall holds, alone or with the
// ground. All: a ball of radius 0.5 m and 1 kg that touches the wall of an arena of 10 m, so that
// its centre runs on rho = 9.5 m.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// No gravity, no friction: 5 m/s along the wall. v_n = 0 is no impact; the ball stays at the wall
/// and turns by v / rho a second.
World makeWhisperingGallery(std::size_t balls, std::uint64_t seed);

/// The same with mu = 0.3 and no spin: slows as v' = -mu v^2 / rho until it rolls at 5/7 of 5 m/s.
World makeWallSlideToRoll(std::size_t balls, std::uint64_t seed);

/// Standard gravity, mu = 0.3: rolls round the wall at Omega = 4 rad/s and, like a ball in a golf
/// cup, falls and rises again at sqrt(2/7) Omega (Gualtieri, Tokieda, Advis-Gaete, Carry, Reffet &
/// Guthmann, "Golfer's dilemma", Am. J. Phys. 74 (2006) 497).
World makeWallRolling(std::size_t balls, std::uint64_t seed);

/// In the corner of wall and ground, standard gravity, mu = 0.3: rolls on the ground at 5 m/s and
/// slides along the wall, which presses with 7/5 v^2 / rho: v' = -mu v^2 / rho, until it rolls on
/// both at 7/9 of 5 m/s.
World makeCornerSlideToRoll(std::size_t balls, std::uint64_t seed);

/// The same with drag, a factor of 0.9 a second, and rolling on both at once, which leaves drag 5/9
/// of what it does in flight.
World makeCornerRolling(std::size_t balls, std::uint64_t seed);

}  // namespace wells
