// Which islands go by exact impacts and which by substeps, under ContactMethod::Auto. Decided from
// what is known at the start of the step about the island alone.
#pragma once

#include <cstdint>
#include <span>

#include "state/world.h"

namespace wells {

/// An island of more balls than this that exact impacts could not move through a step, because
/// contacts in it last, is a crowd: it goes by substeps for the next kCrowdSteps (stepper.h) steps,
/// unless it has half as many balls before. So a gas goes by exact impacts, however dense, and a
/// heap is seldom tried.
inline constexpr std::size_t kCrowd = 64;

/// True where impacts take no energy, which substeps would not keep so. (Rolling resistance takes
/// none in an impact.)
bool isLossless(const Settings& settings);

/// True for a crowd. Never where impacts are lossless, and never with a ball that moves further
/// than its radius in a substep, which substeps might not stop. stepsInSubsteps: by ball, see
/// StepperMemory.
bool isCrowd(const Settings& settings, std::span<const std::uint32_t> island, const Balls& balls,
             std::span<const std::uint8_t> stepsInSubsteps);

}  // namespace wells
