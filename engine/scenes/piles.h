// Piles of balls, of which every force is known. Balls of radius 0.5 m and 1 kg, e = 0.8 and mu =
// 0.3 unless said; gravity 9.81 m/s^2, no wells.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/world.h"

namespace wells {

/// How far apart the three balls at the bottom of a tetrahedral pile are, m.
inline constexpr double kPileGap = 1e-6;

/// e = 0: three balls on the ground, kPileGap apart, and one on top of them. It stands if and only
/// if the friction is at least sqrt(3) - sqrt(2) = 0.31784.
World makeTetrahedralPile(double friction);
World makeStandingPile(std::size_t balls, std::uint64_t seed);  // friction 0.32
World makeSlippingPile(std::size_t balls, std::uint64_t seed);  // friction 0.30

/// e = 0: balls exactly above each other, ten in the catalogue. The contacts carry 9.81 N times the
/// number of balls above them.
World makeColumn(std::size_t balls, std::uint64_t seed);

/// 10^6 kg exactly above 1 kg.
World makeHeavyOnLight(std::size_t balls, std::uint64_t seed);

/// The same, moved aside by kNudge along x: it rolls down, and the light ball out from under it.
World makeNudgedHeavyOnLight(std::size_t balls, std::uint64_t seed);
inline constexpr double kNudge = 1e-6;  // m

}  // namespace wells
