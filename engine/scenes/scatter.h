// Balls at rest, spread at random over the arena: how a world starts when no file says otherwise.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// Adds `count` balls of one radius (m) and mass (kg) at rest, without overlap, spread over the
/// world's arena just above the ground; what does not fit into one layer goes into further layers
/// above. The same seed gives the same bits everywhere. Throws std::invalid_argument when the
/// arena is too narrow for one ball.
void scatterBalls(World& world, std::size_t count, double radius, double mass, std::uint64_t seed);

}  // namespace wells
