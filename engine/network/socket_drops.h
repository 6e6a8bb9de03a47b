// What the kernel dropped at a UDP socket because its receive buffer was full: the one loss on the
// way that happens on this host and that no message tells of.
#pragma once

#include <cstdint>
#include <set>

namespace wells {

/// Descriptors of this process's UDP sockets that are bound to `port`. LCM does not hand out its
/// own; it is the one that is new after LCM has begun to listen. Looks at every open descriptor.
std::set<int> udpSocketsOn(std::uint16_t port);

/// Datagrams dropped at `socket` since it was opened, modulo 2^32; 0 where the kernel (before Linux
/// 4.12) does not tell. One system call.
std::uint32_t droppedAtSocket(int socket);

}  // namespace wells
