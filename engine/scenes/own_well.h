// The well that a peer controls, where nothing else is said.
#pragma once

#include "state/arena.h"
#include "state/wells.h"

namespace wells {

/// Strength (m^3/s^2) of a well that pulls g/8 at half the arena's radius: an eighth of standard
/// gravity there, whatever the world's gravity is, so that a world without gravity has wells too.
/// With d = R/2: S = (g/8) (d^2 + softening^2)^(3/2) / d.
double defaultWellStrength(const Arena& arena, double softening);

/// Where the well of `peer` stands: on the circle of radius R/2 at ball height. The angle from +x
/// towards +z, in turns, is the bit-reversed id - 1 (van der Corput: peers 1, 2, 3, 4 stand at 0,
/// 1/2, 1/4, 3/4), so that any number of peers that count from 1 is spread evenly.
Vec3 defaultWellPosition(const Arena& arena, double ballRadius, PeerId peer);

/// A well at rest with the two above.
WellTrack defaultWell(const Arena& arena, double ballRadius, PeerId peer, double softening = 2);

}  // namespace wells
