// The subcommand "set": changes a live session, from any machine of its group.
#pragma once

#include <span>
#include <string>

namespace wells {

/// The exit status: 1 when a peer has not confirmed, or somebody else's value holds. Throws
/// UsageError before anything is sent, RunError, TransportError.
int runSet(std::span<const std::string> arguments);

}  // namespace wells
