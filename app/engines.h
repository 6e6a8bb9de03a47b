// The engines that --engine names. Two executables hold them, because Bullet's single and double
// precision builds cannot be linked together: gravity-wells has ours and the reference engines,
// gravity-wells-bullet has stock Bullet. Both are this program otherwise.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "state/stepper.h"

namespace wells {

/// All names, of both executables.
std::span<const std::string> engineNames();

/// Throws UsageError, with the allowed names, unless `name` is one of them.
void requireEngine(std::string_view name);

/// Where the engine is in the other executable: becomes that one, which stands beside this one,
/// with the same arguments (argv as main got it), and doesn't return. Throws RunError when that
/// fails.
void becomeExecutableOf(std::string_view engine, char** argv);

/// True for the engines of this executable.
bool hasEngine(std::string_view name);

/// Whether an engine that can let balls at rest sleep does so. Only stock Bullet can.
enum class Sleeping { Off, On };

/// An engine of this executable; hasEngine(name). `threads` are those that a step of ours may use.
std::unique_ptr<Stepper> makeEngine(std::string_view name, Sleeping sleeping = Sleeping::Off,
                                    int threads = 1);

}  // namespace wells
