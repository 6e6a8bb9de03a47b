// Two balls, or a ball and a piece of the arena; and how lists of pairs of balls get into order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/room.h"
#include "threads/thread_pool.h"

namespace wells {

/// Two balls, a < b; or ball a with b = kGround or kWall.
struct BallPair {
  std::uint32_t a;
  std::uint32_t b;
  bool operator==(const BallPair&) const = default;
};

/// What a broadphase finds.
struct CandidateLists {
  std::vector<BallPair> ballPairs;  // by (a, b), each once
  // In no particular order.
  std::vector<std::uint32_t> nearGround;  // balls
  std::vector<std::uint32_t> nearWall;    // once for each piece of the wall that one is near
};

/// Sorts pairs of balls by (a, b) in O(pairs + balls): by b first, then by a, each time by
/// counting.
class PairSorter {
 public:
  /// Numbers of balls are below `balls`. forEachIn(range, visit) calls visit(x, y) for the pairs of
  /// a range < `ranges`, x and y in any order; it is called twice for each.
  template <class ForEachIn>
  void sort(std::size_t balls, std::size_t ranges, ThreadPool& threads, ForEachIn forEachIn,
            std::vector<BallPair>& sorted) {
    const std::size_t parts = threads.ranges(ranges, 1);
    next_.assign(parts * balls, 0);
    const auto forEach = [&](auto visit) {
      threads.forRanges(ranges, 1, [&](std::size_t begin, std::size_t end, std::size_t part) {
        std::uint32_t* const next = next_.data() + part * balls;
        for (std::size_t range = begin; range < end; ++range)
          forEachIn(range, [&](std::uint32_t x, std::uint32_t y) {
            visit(std::min(x, y), next[std::max(x, y)]);
          });
      });
    };
    forEach([](std::uint32_t, std::uint32_t& count) { ++count; });
    const std::size_t pairs = startEach(balls, parts);
    resizeAfresh(lowers_, pairs);
    forEach([&](std::uint32_t lower, std::uint32_t& next) { lowers_[next++] = lower; });
    // Where its last part ends, those of a ball do.
    end_.assign(next_.end() - static_cast<std::ptrdiff_t>(balls), next_.end());
    sortByLower(threads, sorted);
  }

 private:
  std::size_t startEach(std::size_t balls, std::size_t parts);
  void sortByLower(ThreadPool& threads, std::vector<BallPair>& sorted);

  std::vector<std::uint32_t> next_;    // by part and ball: counts, then where its next pair goes
  std::vector<std::uint32_t> lowers_;  // those of each upper ball
  std::vector<std::uint32_t> end_;     // by upper ball, of its lowers
};

}  // namespace wells
