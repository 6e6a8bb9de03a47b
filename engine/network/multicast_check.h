// Looks, before LCM is opened, whether this host lets multicast through: LCM itself takes ten
// seconds to find out and says so on stderr only.
#pragma once

#include "network/lcm_url.h"

namespace wells {

struct MulticastCheck {
  enum class Result { Passes, NoRoute, NotHeard };
  Result result = Result::Passes;
  std::string reason;     // the system's words, empty when it passes
  int receiveBuffer = 0;  // bytes that the kernel grants of url.receiveBuffer
};

/// Sends one small datagram, which is no LCM message, to the group and port with ttl 0, so that it
/// stays on this host, and waits up to a second to hear it.
MulticastCheck checkMulticast(const LcmUrl& url);

}  // namespace wells
