// From a Config to the world at step 0, and to the text by which peers compare their worlds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "config.h"
#include "state/world.h"

namespace wells {

/// s of simulated time in a step: Dt, but Dt x TimeScale with a reference engine.
double stepLength(const Config& config, std::string_view engine);

/// The world at step 0, without this peer's well. Reads BallsFile. Throws UsageError.
World makeWorld(const Config& config, std::string_view engine);

inline constexpr std::size_t kCanonicalLimit = 1000;

/// KEY=VALUE lines of what the world's keys hold, in the table's order, those at their default left
/// out, and of the engine; at most kCanonicalLimit. A balls file counts by its content (a hash
/// of `initial`), as do wells when they are too many to be listed.
std::string canonicalConfig(const Config& config, std::string_view engine, const Balls& initial);

/// Steps in a wall second that keep TimeScale, Hz.
double stepRate(const Config& config, std::string_view engine);

}  // namespace wells
