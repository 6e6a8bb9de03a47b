// The subcommand "spy": a live table of a session, from outside.
#pragma once

#include <span>
#include <string>

namespace wells {

/// The exit status: 1 when no peer was heard, else 0. Throws UsageError, TransportError.
int runSpy(std::span<const std::string> arguments);

}  // namespace wells
