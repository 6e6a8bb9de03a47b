// The subcommand "peers": tells whether multicast passes between machines.
#pragma once

#include <span>
#include <string>

namespace wells {

/// The exit status: 0 when somebody else was heard and hears us, else 1. Throws UsageError,
/// TransportError.
int runPeers(std::span<const std::string> arguments);

}  // namespace wells
