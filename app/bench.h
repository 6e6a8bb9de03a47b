// `gravity-wells bench`: runs a scene with an engine and reports time and physics.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Runs what `arguments` (those behind "bench") ask for. argv as main got it, for engines that live
/// in the other executable. Returns the exit status; throws UsageError and RunError.
int runBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
