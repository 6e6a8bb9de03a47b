#include "network/multicast_check.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>

namespace wells {
namespace {

constexpr std::chrono::milliseconds kPatience{1000};

class UdpSocket {
 public:
  UdpSocket() : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {}
  ~UdpSocket() {
    if (descriptor_ >= 0) close(descriptor_);
  }
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;

  int get() const { return descriptor_; }

  template <class T>
  bool set(int level, int option, const T& value) const {
    return setsockopt(descriptor_, level, option, &value, sizeof value) == 0;
  }

 private:
  int descriptor_;
};

using Nonce = std::array<char, 24>;

Nonce makeNonce() {
  Nonce nonce{"WELLS_PROBE"};
  std::random_device device;
  std::generate(nonce.begin() + 12, nonce.end(), [&] { return static_cast<char>(device()); });
  return nonce;
}

bool hears(const UdpSocket& socket, const Nonce& nonce) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + kPatience;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return false;
    pollfd waiting{socket.get(), POLLIN, 0};
    if (poll(&waiting, 1, static_cast<int>(left.count())) <= 0) continue;
    Nonce heard{};
    const auto size = recv(socket.get(), heard.data(), heard.size(), MSG_DONTWAIT | MSG_TRUNC);
    if (size == static_cast<ssize_t>(heard.size()) && heard == nonce) return true;
  }
}

}  // namespace

MulticastCheck checkMulticast(const LcmUrl& url) {
  using Result = MulticastCheck::Result;
  const auto failed = [](Result result, const std::string& what) {
    return MulticastCheck{result, what + ": " + std::strerror(errno), 0};
  };
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(url.port);
  inet_pton(AF_INET, url.group.c_str(), &group.sin_addr);
  const auto* address = reinterpret_cast<const sockaddr*>(&group);

  // Connecting a datagram socket sends nothing; it only asks the routing table.
  const UdpSocket route, sender, receiver;
  if (route.get() < 0 || sender.get() < 0 || receiver.get() < 0) {
    return failed(Result::NotHeard, "socket");
  }
  if (connect(route.get(), address, sizeof group) < 0) {
    return failed(errno == ENETUNREACH ? Result::NoRoute : Result::NotHeard, "connect");
  }

  MulticastCheck check;
  receiver.set(SOL_SOCKET, SO_RCVBUF, url.receiveBuffer);
  int doubled = 0;  // Linux reports twice what was set, to allow for its own book-keeping
  socklen_t size = sizeof doubled;
  getsockopt(receiver.get(), SOL_SOCKET, SO_RCVBUF, &doubled, &size);
  check.receiveBuffer = std::min(doubled / 2, url.receiveBuffer);

  const ip_mreq membership{group.sin_addr, {INADDR_ANY}};
  const Nonce nonce = makeNonce();
  if (!receiver.set(SOL_SOCKET, SO_REUSEADDR, 1) ||
      bind(receiver.get(), address, sizeof group) < 0) {
    return failed(Result::NotHeard, "bind");
  }
  if (!receiver.set(IPPROTO_IP, IP_ADD_MEMBERSHIP, membership)) {
    return failed(errno == ENODEV ? Result::NoRoute : Result::NotHeard, "joining the group");
  }
  if (!sender.set(IPPROTO_IP, IP_MULTICAST_TTL, 0) ||
      sendto(sender.get(), nonce.data(), nonce.size(), 0, address, sizeof group) < 0) {
    return failed(errno == ENETUNREACH ? Result::NoRoute : Result::NotHeard, "sending");
  }
  if (!hears(receiver, nonce)) {
    check.result = Result::NotHeard;
    check.reason = "a datagram to the group was sent and not heard within a second";
  }
  return check;
}

}  // namespace wells
