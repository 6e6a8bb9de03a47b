// Strong ids: a ball cannot be mistaken for a peer, nor a count for either.
#pragma once

#include <compare>
#include <cstdint>
#include <limits>

namespace wells {

/// Index of a ball in the world's arrays; ids are 0 .. N-1, each exactly once.
enum class BallId : std::uint32_t {};

constexpr std::uint32_t index(BallId id) {
  return static_cast<std::uint32_t>(id);
}

/// A peer of a session: 1 .. kMaxPeerId. 0 is nobody.
enum class PeerId : std::int32_t {};

inline constexpr PeerId kNobody{0};
inline constexpr std::int32_t kMaxPeerId = 255;  // far above any lab; keeps tables small

constexpr std::int32_t value(PeerId id) {
  return static_cast<std::int32_t>(id);
}

}  // namespace wells
