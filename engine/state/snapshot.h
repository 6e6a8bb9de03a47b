// A world between two steps, together with what its engine remembers, as bytes: whoever decodes
// them goes on with the same bits. Not a message (a session's peers send balls, not worlds), and no
// files: those are the program's.
//
// Format 3, little-endian, no padding:
//   8 bytes  "wellsnap"
//   u32      format version
//   u64      length of the whole in bytes
//   ...      the fields, in the order of snapshot.cpp; a list is its u64 count and its items
//   u64      Hash (math/hash.h) of every byte before
// Doubles travel as their 64 bits: -0.0 and the payload of a NaN survive.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "state/stepper.h"
#include "state/world.h"

namespace wells {

struct Snapshot {
  World world;
  StepperMemory memory;
  std::string engine{};  // Stepper::name() of the engine whose memory it is
  /// Names and values with which the program that saves can go on; not looked at here.
  std::vector<std::pair<std::string, std::string>> config{};
};

inline constexpr std::uint32_t kSnapshotVersion = 3;

/// what() says what is wrong: no snapshot, another version, cut, altered, or a field with its value
/// and what is allowed.
class SnapshotError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws SnapshotError for what decode() would refuse. O(size).
std::string encode(const Snapshot& snapshot);

/// The snapshot, with every bit that was encoded. A ball's state may be anything, because a ball
/// that is not finite is legal (Stepper::quarantined); so may the impulses that it left behind.
/// Every other field is in its range. Throws SnapshotError; allocates no more than a few times the
/// size of `bytes`.
Snapshot decode(std::string_view bytes);

}  // namespace wells
