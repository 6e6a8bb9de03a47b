#include "broadphase/ball_pair.h"

namespace wells {
namespace {

constexpr std::size_t kLeastRange = 8192;  // balls, whose pairs a thread sorts

}  // namespace

/// Turns counts into starts; returns their sum.
std::size_t PairSorter::startEach(std::size_t balls, std::size_t parts) {
  std::uint32_t sum = 0;
  for (std::size_t ball = 0; ball < balls; ++ball)
    for (std::size_t part = 0; part < parts; ++part)
      sum += std::exchange(next_[part * balls + ball], sum);
  return sum;
}

void PairSorter::sortEach(std::size_t balls, std::size_t parts, ThreadPool& threads,
                          std::vector<BallPair>& sorted) const {
  // Where the last part of a ball ended, the next ball begins.
  const std::uint32_t* const ends = next_.data() + (parts - 1) * balls;
  threads.forRanges(balls, kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t ball = begin; ball < end; ++ball) {
      const std::uint32_t first = ball == 0 ? 0 : ends[ball - 1];
      std::sort(sorted.begin() + first, sorted.begin() + ends[ball],
                [](const BallPair& x, const BallPair& y) { return x.b < y.b; });
    }
  });
}

}  // namespace wells
