// Why a received message was refused, and how often. A refused message changes nothing else.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

namespace wells {

enum class Drop : std::uint8_t {
  // By its bytes alone.
  UnknownChannel,
  WrongSize,    // larger than allowed, or not what its own count field says
  BadCount,     // a count or string length that is out of bounds
  Undecodable,  // not one of our types, or of another revision of it
  WrongProtocol,
  OutOfRange,  // a number that is not finite or outside its range
  // By who sent it, and when.
  Echo,           // our own message; no fault
  NotJoined,      // about a session that we have not joined yet; no fault
  DuplicateId,    // another peer that uses our id and has to give it up
  ClockApart,     // sent at another time than ours by more than the tolerance
  ForeignWorld,   // the sender's world config differs
  UnknownSender,  // no heartbeat of this incarnation was heard yet
  DeadSender,     // it said good-bye, or its peer has a newer incarnation that lives
  Replayed,       // its sequence number was seen before, or is too old to tell
  ForeignGeneration,
  NotActive,  // the sender has no say in the world yet
  // By what it claims about a ball.
  ImpossibleVersion,
  NotOwner,     // the tenure that it claims belongs to somebody else
  TooFarAhead,  // its step is so far in the future that we cannot keep it
};

inline constexpr std::size_t kDropReasons = static_cast<std::size_t>(Drop::TooFarAhead) + 1;

/// For reports: "wrong size", "foreign generation", ...
std::string_view name(Drop reason);

class DropCounts {
 public:
  void add(Drop reason) { ++counts_[static_cast<std::size_t>(reason)]; }
  std::int64_t operator[](Drop reason) const { return counts_[static_cast<std::size_t>(reason)]; }

  /// Those that happened and are faults, in the order of their reasons.
  std::vector<std::pair<Drop, std::int64_t>> faults() const;

  /// Of the faults.
  std::int64_t total() const;

 private:
  std::array<std::int64_t, kDropReasons> counts_{};
};

}  // namespace wells
