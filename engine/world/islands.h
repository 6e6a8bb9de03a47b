// Islands: groups of balls that hang together by pairs that may meet within the step. What happens
// in one does not depend on another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "broadphase/broadphase.h"

namespace wells {

class Islands {
 public:
  /// Splits `among`, rising ids, by the pairs, which name no others. Both lists are in order of (a,
  /// b). A ball in no pair is in no island.
  void find(std::span<const BallPair> ballPairs, std::span<const BallPair> arenaPairs,
            std::span<const std::uint32_t> among);

  std::size_t count() const { return ballStart_.empty() ? 0 : ballStart_.size() - 1; }

  /// Rising ids. Islands are in order of their lowest ball.
  std::span<const std::uint32_t> balls(std::size_t island) const {
    return std::span(balls_).subspan(ballStart_[island],
                                     ballStart_[island + 1] - ballStart_[island]);
  }

  /// Those between balls first, then those with the arena, each in the order of the lists.
  std::span<const BallPair> pairs(std::size_t island) const {
    return std::span(pairs_).subspan(pairStart_[island],
                                     pairStart_[island + 1] - pairStart_[island]);
  }

 private:
  // By ball; only those of the last find() are valid.
  std::vector<std::uint32_t> parent_;  // union-find
  std::vector<std::uint32_t> islandOf_;
  std::vector<std::uint8_t> isPaired_;  // of the roots, with a ball or the arena
  // By island.
  std::vector<std::uint32_t> balls_, ballStart_, pairStart_, next_;
  std::vector<BallPair> pairs_;
};

}  // namespace wells
