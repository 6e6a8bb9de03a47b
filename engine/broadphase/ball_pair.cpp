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

void PairSorter::sortByLower(ThreadPool& threads, std::vector<BallPair>& sorted) {
  const std::size_t balls = end_.size();
  const std::size_t parts = threads.ranges(balls, kLeastRange);
  next_.assign(parts * balls, 0);
  const auto forEach = [&](auto visit) {
    threads.forRanges(
        balls, kLeastRange, [&](std::size_t begin, std::size_t end, std::size_t part) {
          std::uint32_t* const next = next_.data() + part * balls;
          std::uint32_t at = begin == 0 ? 0 : end_[begin - 1];
          for (std::size_t upper = begin; upper < end; ++upper)
            for (; at < end_[upper]; ++at)
              visit(static_cast<std::uint32_t>(upper), lowers_[at], next[lowers_[at]]);
        });
  };
  forEach([](std::uint32_t, std::uint32_t, std::uint32_t& count) { ++count; });
  resizeAfresh(sorted, startEach(balls, parts));
  forEach([&](std::uint32_t upper, std::uint32_t lower, std::uint32_t& next) {
    sorted[next++] = {lower, upper};
  });
}

}  // namespace wells
