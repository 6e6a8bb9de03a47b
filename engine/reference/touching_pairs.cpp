#include "reference/touching_pairs.h"

#include <algorithm>
#include <cmath>

namespace wells {

const std::vector<TouchingPairs::Pair>& TouchingPairs::find(const Balls& balls) {
  byX_.clear();
  pairs_.clear();
  double largest = 0;
  for (std::uint32_t i = 0; i < balls.size(); ++i) {
    if (!std::isfinite(balls.position[i].x())) continue;
    byX_.emplace_back(balls.position[i].x(), i);
    largest = std::max(largest, balls.radius[i]);
  }
  std::sort(byX_.begin(), byX_.end());

  // No margin for rounding is needed: rounded sums and squares keep their order, and the squares of
  // two different doubles stay different, so touch() accepts no pair with |dx| > r1 + r2.
  for (std::size_t a = 0; a < byX_.size(); ++a) {
    const auto [x, i] = byX_[a];
    const double reach = balls.radius[i] + largest;
    for (std::size_t b = a + 1; b < byX_.size() && byX_[b].first - x <= reach; ++b) {
      const std::uint32_t j = byX_[b].second;
      if (!touch(balls, i, j)) continue;
      pairs_.emplace_back(i, j);
      pairs_.emplace_back(j, i);
    }
  }
  std::sort(pairs_.begin(), pairs_.end());
  return pairs_;
}

}  // namespace wells
