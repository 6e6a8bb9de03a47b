// The scenes of SimBenchmark that balls alone can express (Kang and Hwangbo,
// "SimBenchmark", 2018, which compares RaiSim, Bullet, ODE, MuJoCo and DART on them): balls of
// radius 0.1 m and 10 kg on frictionless ground, standard gravity, no wells. How it defines its
// errors: exact_answers.h. Its ground has no wall; ours is 500 m wide, as its ground is, and nobody
// gets that far.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// e = 1: 7 x 7 balls, 2 m apart, released at rest with their centres at y = 5 m.
World makeBouncing(std::size_t balls, std::uint64_t seed);

/// e = 0: 6 x 6 x 6 balls at rest, centres 0.21 m apart, the lowest at y = 0.101 m, each moved by a
/// random 0 to 1 mm along each axis. They fall on the ground and run apart.
World makeBlock(std::size_t balls, std::uint64_t seed);

/// e = 1: the same, the lowest at y = 1.101 m.
World makeElasticBlock(std::size_t balls, std::uint64_t seed);

}  // namespace wells
