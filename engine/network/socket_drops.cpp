#include "network/socket_drops.h"

#include <linux/sock_diag.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <string>
#include <system_error>

namespace wells {
namespace {

bool isUdpSocketOn(std::uint16_t port, int descriptor) {
  int type = 0;
  socklen_t size = sizeof type;
  if (getsockopt(descriptor, SOL_SOCKET, SO_TYPE, &type, &size) != 0 || type != SOCK_DGRAM)
    return false;
  sockaddr_in name{};
  size = sizeof name;
  return getsockname(descriptor, reinterpret_cast<sockaddr*>(&name), &size) == 0 &&
         name.sin_family == AF_INET && ntohs(name.sin_port) == port;
}

}  // namespace

std::set<int> udpSocketsOn(std::uint16_t port) {
  std::set<int> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string name = entry.path().filename();
    int descriptor = -1;
    std::from_chars(name.data(), name.data() + name.size(), descriptor);
    if (isUdpSocketOn(port, descriptor)) found.insert(descriptor);
  }
  return found;
}

std::uint32_t droppedAtSocket(int socket) {
  // The same number as in the last column of /proc/net/udp, which would have to be read whole and
  // searched for the socket's inode.
  std::array<std::uint32_t, SK_MEMINFO_VARS> memory{};
  socklen_t size = sizeof memory;
  if (getsockopt(socket, SOL_SOCKET, SO_MEMINFO, memory.data(), &size) != 0) return 0;
  return memory[SK_MEMINFO_DROPS];
}

}  // namespace wells
