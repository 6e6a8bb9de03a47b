// The benchmark "curve": how much overlap a heap's solver leaves against the time that it takes,
// over its settings, beside stock Bullet in the same run.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Parses and runs "bench curve"; `arguments` without these words, argv as main got it. Throws
/// UsageError and RunError.
int runCurveBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
