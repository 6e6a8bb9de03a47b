// The contacts that are possible within a step: the broadphase's pairs, narrowed by how far each
// ball may move, in an order that does not depend on the broadphase's history.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"
#include "state/arena.h"
#include "state/world.h"

namespace wells {

/// Ghosts whose gap is at most this, of the sum of their radii, count as touching.
inline constexpr double kLeaningGap = 0.05;

class Candidates {
 public:
  /// Lists the contacts between balls and those with the arena, each by (a, b). reach[i] (m) bounds
  /// how far ball i moves in the step; NaN: the ball is in no pair. `among` are the balls that take
  /// part, as Broadphase has it.
  void find(const World& world, std::span<const double> reach, std::span<const std::uint32_t> among,
            std::vector<BallPair>& balls, std::vector<BallPair>& arena);

  /// These take no part from the next find() on, until they are among its balls again.
  void remove(std::span<const std::uint32_t> balls) { broadphase_.remove(balls); }

  /// Of the last find(): pairs of the broadphase.
  std::int64_t pairs() const;

  /// Of the last find(): pairs of balls that may touch.
  std::span<const BallPair> ballPairs() const { return listed_; }
  /// Likewise, ghosts that touch ghosts or nearly do; see isLeaning().
  std::span<const BallPair> leaningPairs() const { return leaning_; }

  /// By ball, 1 for ghosts that touch ghosts: a contact between other peers' balls is theirs to
  /// compute. Here such balls only stop falling, because what holds them is not known.
  std::span<const std::uint8_t> isLeaning() const { return isLeaning_; }

 private:
  void findBalls(const World& world, std::span<const double> reach,
                 std::vector<BallPair>& contacts);
  void findArena(const World& world, std::span<const double> reach,
                 std::vector<BallPair>& contacts);

  Broadphase broadphase_;
  std::vector<std::uint64_t> sorted_;  // a in the upper half, b in the lower
  std::vector<BallPair> leaning_;
  std::vector<BallPair> listed_;
  std::vector<std::uint8_t> isLeaning_;
};

}  // namespace wells
