// `gravity-wells bench stress`: the stress cases with every engine, as a table: who loses balls,
// makes energy from nothing, or never ends.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Runs what `arguments` (those behind "stress") ask for. argv as main got it, for engines that
/// live in the other executable. Returns the exit status; throws UsageError and RunError.
int runStressBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
