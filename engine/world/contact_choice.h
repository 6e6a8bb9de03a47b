// Which islands go by exact impacts and which by substeps, under ContactMethod::Auto. Decided from
// what is known at the start of the step about the island alone.
#pragma once

#include <cstdint>
#include <span>

#include "state/world.h"

namespace wells {

/// An island of more balls than this is a crowd: its impacts are chaos, so that exact times buy
/// nothing, and it goes by substeps. It remains one until it has half as many, so that an island
/// near the limit does not change its method at every step.
inline constexpr std::size_t kCrowd = 64;

/// True where impacts take no energy, which substeps would not keep so. (Rolling resistance takes
/// none in an impact.)
bool isLossless(const Settings& settings);

/// True for a crowd. Never where impacts are lossless, and never with a ball that moves further
/// than its radius in a substep, which substeps might not stop. inSubsteps: by ball, 1 where its
/// island was a crowd in the step before.
bool isCrowd(const Settings& settings, std::span<const std::uint32_t> island, const Balls& balls,
             std::span<const std::uint8_t> inSubsteps);

}  // namespace wells
