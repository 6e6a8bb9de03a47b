#include "broadphase/ball_pair.h"

#include <utility>

namespace wells {

void PairSorter::finish(std::vector<BallPair>& sorted) {
  for (auto* starts : {&lowerStart_, &upperStart_}) {
    std::uint32_t sum = 0;
    for (std::uint32_t& start : *starts) sum += std::exchange(start, sum);
  }
  if (lowers_.size() < count_) lowers_.resize(pairs_.size());
  for (std::size_t n = 0; n < count_; ++n) lowers_[upperStart_[pairs_[n].b]++] = pairs_[n].a;
  sorted.resize(count_);
  // Each ball's start has moved to its end.
  std::uint32_t at = 0;
  for (std::uint32_t upper = 0; upper + 1 < upperStart_.size(); ++upper)
    for (; at < upperStart_[upper]; ++at) {
      const std::uint32_t lower = lowers_[at];
      sorted[lowerStart_[lower]++] = {lower, upper};
    }
}

}  // namespace wells
