// `gravity-wells peer`: one peer from start to end.
#pragma once

#include "peer_options.h"

namespace wells {

/// Runs until the end that the options name, or an interrupt, and writes the files that they ask
/// for. Returns the exit status. Throws UsageError and RunError.
int runPeer(PeerOptions options);

}  // namespace wells
