// The parts of an LCM URL for UDP multicast: udpm://GROUP:PORT?ttl=HOPS&recv_buf_size=BYTES.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wells {

/// The user's URL is wrong: what() names the part, its value and what is allowed.
class LcmUrlError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct LcmUrl {
  std::string group = "239.255.76.67";  // LCM's own default; 224.0.0.0 .. 239.255.255.255
  std::uint16_t port = 7667;            // LCM's own default; 1 .. 65535
  int ttl = 0;                          // routers to cross + 1; 0 stays on this host, 1 on the LAN

  // bytes asked of the kernel for what has arrived and was not read yet; it grants at most
  // net.core.rmem_max
  int receiveBuffer = 2'097'152;

  std::string text() const;
};

/// What the URL leaves out keeps its default above. Throws LcmUrlError.
LcmUrl parseLcmUrl(std::string_view text);

/// URL of LCM's default group on a port of ours. Throws LcmUrlError outside the ranges above.
std::string lcmUrl(int port, int ttl);

}  // namespace wells
