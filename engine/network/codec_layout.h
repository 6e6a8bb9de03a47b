// The layout of each message: where its counts and lengths stand, so that they can be compared with
// the size of what came before anything is decoded. All are big-endian int32.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "network/drops.h"

namespace wells {

/// Goes through the bytes of a message from front to back. After the first fault it stands still.
class MessageWalk {
 public:
  explicit MessageWalk(std::span<const std::byte> bytes) : bytes_(bytes) {}

  void skip(std::size_t bytes);

  /// Reads a count; 0 after a fault.
  std::int32_t count(std::int32_t low, std::int32_t high);

  /// Skips a string of at most `longest` bytes; its length counts the zero byte that ends it.
  void string(std::size_t longest);

  /// What was wrong, if anything; that bytes are left over is wrong, too.
  std::optional<Drop> end() const;

 private:
  std::span<const std::byte> bytes_;  // those that are left
  std::optional<Drop> fault_;
};

// One for each type, in the order of its fields.
void walkHeartbeat(MessageWalk& walk);
void walkWells(MessageWalk& walk);
void walkBallStates(MessageWalk& walk);
void walkOffers(MessageWalk& walk);
void walkWorldConfig(MessageWalk& walk);
void walkStatistics(MessageWalk& walk);
void walkSettings(MessageWalk& walk);  // of settings_t and of request_t

}  // namespace wells
