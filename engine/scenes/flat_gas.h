// A gas in one layer: discs on a plane, as far as the balls are concerned.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// No gravity, no wells, e = 1, mu = 0; all centres at y = 1 m, spread at random over the arena of
/// R = 80 sqrt(N / 4000) m; 5 m/s in random horizontal directions. They stay in their plane.
World makeFlatGas(std::size_t balls, std::uint64_t seed);

/// The same with e = 0.9.
World makeCoolingGas(std::size_t balls, std::uint64_t seed);

}  // namespace wells
