#include "broadphase/ball_pair.h"

#include <span>
#include <utility>

namespace wells {

void PairSorter::finish(std::vector<BallPair>& sorted) {
  for (auto* starts : {&lowerStart_, &upperStart_}) {
    std::uint32_t sum = 0;
    for (std::uint32_t& start : *starts) sum += std::exchange(start, sum);
  }
  if (lowers_.size() < count_) lowers_.resize(pairs_.size());
  for (const BallPair& pair : std::span(pairs_).first(count_))
    lowers_[upperStart_[pair.b]++] = pair.a;
  sorted.resize(count_);
  std::uint32_t at = 0;
  for (std::uint32_t upper = 0; upper + 1 < upperStart_.size(); ++upper) {
    const std::uint32_t end = upperStart_[upper];  // it has moved there from the start
    for (; at < end; ++at) {
      const std::uint32_t lower = lowers_[at];
      sorted[lowerStart_[lower]++] = {lower, upper};
    }
  }
}

}  // namespace wells
