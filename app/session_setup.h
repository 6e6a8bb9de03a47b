// What a session needs from the config: options and transport.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "network/lcm_transport.h"
#include "network/session_options.h"
#include "peer_options.h"
#include "well_motion.h"

namespace wells {

/// The way to the other peers, and what it says of itself.
struct Link {
  std::unique_ptr<Transport> transport;
  LcmTransport* lcm = nullptr;  // the same, if it is LCM
  std::string notice;           // for the user; empty: all is well
};

/// LCM, or, where multicast does not pass and --require-lcm was not given, memory alone. Throws
/// RunError.
Link openLink(const PeerOptions& options);

/// `motion` must outlive the session; `initial` is the world at step 0.
SessionOptions makeSessionOptions(const PeerOptions& options, const World& initial,
                                  const WellMotion& motion, const Link& link,
                                  std::function<void(const std::string&)> notice);

}  // namespace wells
