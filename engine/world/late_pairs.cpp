#include "world/late_pairs.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace wells {
namespace {

constexpr double kLateOverlap = 1e-6;       // of the sum of radii
constexpr std::size_t kLeastRange = 16384;  // pairs, that a thread looks at

}  // namespace

std::int64_t LatePairs::count(const World& world, std::span<const BallPair> pairs,
                              std::span<const BallState> start,
                              std::span<const std::uint32_t> awake, ThreadPool& threads) {
  tookPart_.resize(world.balls.size(), 0);
  if (step_ + 1 != world.step) std::ranges::fill(tookPart_, std::uint8_t{0});
  std::array<std::int64_t, kMostThreads> late{};
  threads.forRanges(pairs.size(), kLeastRange,
                    [&](std::size_t begin, std::size_t end, std::size_t range) {
                      late[range] = countIn({begin, end}, world, pairs, start);
                    });
  before_.resize(pairs.size());
  std::ranges::copy(pairs, before_.begin());
  std::ranges::fill(tookPart_, std::uint8_t{0});
  for (const std::uint32_t i : awake) tookPart_[i] = 1;
  step_ = world.step;
  return std::accumulate(late.begin(), late.end(), std::int64_t{0});
}

std::int64_t LatePairs::countIn(IndexRange range, const World& world,
                                std::span<const BallPair> pairs,
                                std::span<const BallState> start) const {
  const auto isBefore = [](const BallPair& x, const BallPair& y) {
    return x.a != y.a ? x.a < y.a : x.b < y.b;
  };
  if (range.begin == range.end) return 0;
  std::int64_t late = 0;
  auto old = std::ranges::lower_bound(before_, pairs[range.begin], isBefore);
  for (const BallPair& pair : pairs.subspan(range.begin, range.end - range.begin)) {
    while (old != before_.end() && isBefore(*old, pair)) ++old;
    if (old != before_.end() && *old == pair)
      ++old;  // so that the next is most often the one that is looked for
    else if (isLate(world, pair, start))
      ++late;
  }
  return late;
}

bool LatePairs::isLate(const World& world, const BallPair& pair,
                       std::span<const BallState> start) const {
  const auto [a, b] = pair;
  const double most = (1 - kLateOverlap) * (world.balls.radius[a] + world.balls.radius[b]);
  return squaredLength(start[b].position - start[a].position) < most * most && tookPart_[a] &&
         tookPart_[b] && world.owns(a) && world.owns(b);
}

}  // namespace wells
