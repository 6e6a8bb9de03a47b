// What the session knows of a network: publish bytes on a channel, poll what came. LCM multicast,
// and an in-memory network for tests, stand behind it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace wells {

/// Largest message that we send or accept, bytes. With LCM's header and the channel's name it fits
/// one Ethernet frame, so that the loss of a frame loses one message.
inline constexpr std::size_t kMaxMessageBytes = 1400;

/// Everything since the start.
struct TransportCounts {
  std::int64_t messagesSent = 0;
  std::int64_t bytesSent = 0;
  std::int64_t messagesReceived = 0;
  std::int64_t bytesReceived = 0;
  std::int64_t droppedSending = 0;    // could not be sent
  std::int64_t droppedReceiving = 0;  // too large, or no room in our queue
  std::int64_t droppedByKernel = 0;   // no room in the socket's buffer; up to a second old
};

class Transport {
 public:
  using Handler = std::function<void(std::string_view channel, std::span<const std::byte> bytes)>;

  virtual ~Transport() = default;

  /// Sends a message of at most kMaxMessageBytes to everybody in the group. A larger one, or one
  /// that the network refuses, is counted as dropped.
  virtual void publish(std::string_view channel, std::span<const std::byte> bytes) = 0;

  /// Hands every message that has arrived to `handler`, in order of arrival, without waiting. A
  /// sender may or may not hear its own messages.
  virtual void poll(const Handler& handler) = 0;

  virtual TransportCounts counts() const = 0;

  /// For reports: "lcm udpm://239.255.76.67:9171?ttl=0" or "memory".
  virtual std::string description() const = 0;
};

}  // namespace wells
