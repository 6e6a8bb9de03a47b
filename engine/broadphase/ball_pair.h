// Two balls, or a ball and a piece of the arena; and how lists of pairs of balls get into order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace wells {

/// Two balls, a < b; or ball a with b = kGround or kWall.
struct BallPair {
  std::uint32_t a;
  std::uint32_t b;
  bool operator==(const BallPair&) const = default;
};

/// Sorts pairs of balls by (a, b) in O(pairs + balls): by b first, then by a, each time by
/// counting.
class PairSorter {
 public:
  /// Numbers of balls are below `balls`; at most `most` pairs are added.
  void begin(std::size_t balls, std::size_t most) {
    count_ = 0;
    if (pairs_.size() < most) pairs_.resize(most);
    lowerStart_.assign(balls + 1, 0);
    upperStart_.assign(balls + 1, 0);
  }

  /// Two balls, in any order.
  void add(std::uint32_t x, std::uint32_t y) {
    const std::uint32_t lower = x < y ? x : y;
    const std::uint32_t upper = x < y ? y : x;
    ++lowerStart_[lower];
    ++upperStart_[upper];
    pairs_[count_++] = {lower, upper};
  }

  /// All that were added.
  void finish(std::vector<BallPair>& sorted);

 private:
  std::vector<BallPair> pairs_;  // count_ of them are valid
  std::size_t count_ = 0;
  std::vector<std::uint32_t> lowerStart_, upperStart_;  // by ball: counts, then where its pairs go
  std::vector<std::uint32_t> lowers_;                   // by upper ball
};

}  // namespace wells
