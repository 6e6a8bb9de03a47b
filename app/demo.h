// `gravity-wells demo`: two peers as two processes on this machine share the template world by LCM
// multicast, each with a slowly moving well, and a summary of what they did.
#pragma once

#include <span>
#include <string>

namespace wells {

/// Arguments behind "demo". Returns the exit status. Throws UsageError and RunError.
int runDemo(std::span<const std::string> arguments);

}  // namespace wells
