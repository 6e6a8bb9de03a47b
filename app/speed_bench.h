// The benchmark "speed": ours beside stock Bullet on scenes of 25 to 100,000 balls, where the time
// of a step of ours goes, and what sleep saves.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Parses and runs "bench speed"; `arguments` without these words, argv as main got it. Throws
/// UsageError and RunError.
int runSpeedBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
