// `gravity-wells bench accuracy`: the work-precision benchmark, error against CPU time of every
// engine and method on the cases with exact answers; tables and plots.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Runs what `arguments` (those behind "accuracy") ask for. argv as main got it, for engines that
/// live in the other executable. Returns the exit status; throws UsageError and RunError.
int runAccuracyBench(std::span<const std::string> arguments, char** argv);

}  // namespace wells
