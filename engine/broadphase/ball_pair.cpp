#include "broadphase/ball_pair.h"

#include <utility>

namespace wells {

void PairSorter::finish(std::vector<BallPair>& sorted) {
  for (auto* starts : {&lowerStart_, &upperStart_}) {
    std::uint32_t sum = 0;
    for (std::uint32_t& start : *starts) sum += std::exchange(start, sum);
  }
  lowers_.resize(pairs_.size());
  for (const BallPair& pair : pairs_) lowers_[upperStart_[pair.b]++] = pair.a;
  sorted.resize(pairs_.size());
  // Each ball's start has moved to its end.
  std::uint32_t at = 0;
  for (std::uint32_t upper = 0; upper + 1 < upperStart_.size(); ++upper)
    for (; at < upperStart_[upper]; ++at) {
      const std::uint32_t lower = lowers_[at];
      sorted[lowerStart_[lower]++] = {lower, upper};
    }
}

}  // namespace wells
