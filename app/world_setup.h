// From a Config to the world at step 0, and to the text by which peers compare their worlds.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "config.h"
#include "state/world.h"

namespace wells {

/// The world at step 0, without this peer's well. For a reference engine settings.dt is
/// Dt x TimeScale. Reads BallsFile. Throws UsageError.
World makeWorld(const Config& config, std::string_view engine);

inline constexpr std::size_t kMaxCanonicalBytes = 1000;

/// KEY=VALUE lines of what the world's keys hold, in the table's order, those at their default left
/// out, and of the engine; at most kMaxCanonicalBytes. A balls file counts by its content (a hash
/// of `initial`), as do wells when they are too many to be listed.
std::string canonicalConfig(const Config& config, std::string_view engine, const Balls& initial);

/// Wall time that a step should take at TimeScale, s.
double secondsPerStep(const Config& config, std::string_view engine);

}  // namespace wells
