// By which interface this machine sends to a multicast group. Sends nothing on the network.
#pragma once

#include <optional>
#include <string>

#include "network/lcm_url.h"

namespace wells {

struct MulticastRoute {
  std::string interface;  // "eth0"
  std::string address;    // this machine's there, "192.168.1.5"; empty: it has none

  bool staysHere() const { return interface == "lo"; }
};

/// Nothing when there is no route, or the kernel does not tell.
std::optional<MulticastRoute> multicastRoute(const LcmUrl& url);

}  // namespace wells
