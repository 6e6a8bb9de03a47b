// Two balls, or a ball and a piece of the arena; and how lists of pairs of balls get into order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "threads/thread_pool.h"

namespace wells {

/// Two balls, a < b; or ball a with b = kGround or kWall.
struct BallPair {
  std::uint32_t a;
  std::uint32_t b;
  bool operator==(const BallPair&) const = default;
};

/// Sorts pairs of balls by (a, b): by a by counting, then those of each a, which are few.
class PairSorter {
 public:
  /// Numbers of balls are below `balls`. forEachIn(range, visit) calls visit(x, y) for the pairs of
  /// a range < `ranges`, x and y in any order; it is called twice for each.
  template <class ForEachIn>
  void sort(std::size_t balls, std::size_t ranges, ThreadPool& threads, ForEachIn forEachIn,
            std::vector<BallPair>& sorted) {
    const std::size_t parts = threads.ranges(ranges, 1);
    next_.assign(parts * balls, 0);
    const auto forEachOf = [&](std::size_t begin, std::size_t end, auto visit) {
      for (std::size_t range = begin; range < end; ++range)
        forEachIn(range,
                  [&](std::uint32_t x, std::uint32_t y) { visit(std::min(x, y), std::max(x, y)); });
    };
    threads.forRanges(ranges, 1, [&](std::size_t begin, std::size_t end, std::size_t part) {
      std::uint32_t* const count = next_.data() + part * balls;
      forEachOf(begin, end, [&](std::uint32_t lower, std::uint32_t) { ++count[lower]; });
    });
    sorted.resize(startEach(balls, parts));
    threads.forRanges(ranges, 1, [&](std::size_t begin, std::size_t end, std::size_t part) {
      std::uint32_t* const next = next_.data() + part * balls;
      forEachOf(begin, end, [&](std::uint32_t lower, std::uint32_t upper) {
        sorted[next[lower]++] = {lower, upper};
      });
    });
    sortEach(balls, parts, threads, sorted);
  }

 private:
  std::size_t startEach(std::size_t balls, std::size_t parts);
  void sortEach(std::size_t balls, std::size_t parts, ThreadPool& threads,
                std::vector<BallPair>& sorted) const;

  std::vector<std::uint32_t> next_;  // by part and ball: counts, then where its next pair goes
};

}  // namespace wells
