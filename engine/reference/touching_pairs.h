// Which balls touch: the same pairs as a test of all pairs, found by sorting along x.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "state/balls.h"

namespace wells {

/// The report's test: d^2 <= (r1 + r2)^2. The same bits whichever ball is named first.
inline bool touch(const Balls& balls, std::size_t i, std::size_t j) {
  const double reach = balls.radius[i] + balls.radius[j];
  return squaredLength(balls.position[i] - balls.position[j]) <= reach * reach;
}

class TouchingPairs {
 public:
  using Pair = std::pair<std::uint32_t, std::uint32_t>;

  /// All ordered pairs (i, j), i != j, that touch(), each in both orders, by i, then j; valid until
  /// the next call. O(n log n + pairs that overlap in x). A ball without a finite x touches none.
  const std::vector<Pair>& find(const Balls& balls);

 private:
  std::vector<std::pair<double, std::uint32_t>> byX_;
  std::vector<Pair> pairs_;
};

}  // namespace wells
