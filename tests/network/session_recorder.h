// Records what the peers of a test group publish, and keeps what they know to compare it later.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "network/session_group.h"

namespace wells {

/// Everything that is published, to be looked at and to be played back.
class Recorder {
 public:
  explicit Recorder(Group& group) : transport_(group.sharedNetwork()) {}

  void record() {
    transport_.poll([&](std::string_view channel, std::span<const std::byte> bytes) {
      messages_.emplace_back(channel, std::vector<std::byte>(bytes.begin(), bytes.end()));
    });
  }
  const auto& messages() const { return messages_; }
  void clear() { messages_.clear(); }
  void send(std::string_view channel, std::span<const std::byte> bytes) {
    transport_.publish(channel, bytes);
  }
  void send(const Message& message) {
    MessageBuffer buffer;
    const auto bytes = encode(message, buffer);
    send(std::visit([](const auto& m) { return channelOf(m); }, message), bytes);
  }

 private:
  MemoryTransport transport_;
  std::vector<std::pair<std::string, std::vector<std::byte>>> messages_;
};

struct Snapshot {
  std::vector<Record> records;
  std::vector<Vec3> positions;
  std::vector<Role> roles;
  bool operator==(const Snapshot&) const = default;
};

inline std::vector<Snapshot> snapshot(const Group& group) {
  std::vector<Snapshot> snapshots;
  for (const auto& peer : const_cast<Group&>(group).peers())
    snapshots.push_back({peer->session->records(), peer->world.balls.position, peer->world.roles});
  return snapshots;
}

}  // namespace wells
