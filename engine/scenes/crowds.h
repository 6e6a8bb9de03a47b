// Scenes of many balls: heaps, gas, a settled layer, and the world of the original template.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// T1. Balls (radius 0.5 m, 1 kg) on a jittered cubic lattice (spacing 1.2 m, jitter 0.05 m) from
/// y = 1 m up, filling the disc of radius R - 1 layer by layer; R = 40 sqrt(N / 10000) m, but 40 m
/// at N = 25. Wells at (+-R/2, 1, 0), (0, 1, +-R/2) with S = g R^2 / 8, softening 2 m. e = 0.8,
/// mu = 0.3.
World makeWellsCrowd(std::size_t balls, std::uint64_t seed);

/// T2. No gravity, no wells, e = 1, mu = 0; three layers of spacing 2.4 m, R = 80 sqrt(N / 10000)
/// m; speed 5 m/s in random directions.
World makeGas(std::size_t balls, std::uint64_t seed);

/// T3. One layer at rest on the ground, spacing 1.2 m, e = 0, mu = 0.5, R = 80 sqrt(N / 10000) m.
World makeSettledLayer(std::size_t balls, std::uint64_t seed);

/// The world of config/template.txt with the well of peer 1.
World makeTemplateWorld(std::size_t balls, std::uint64_t seed);

}  // namespace wells
